# SPDX-License-Identifier: MIT
"""The panels in which users edit document objects; same file names as in objects/."""
