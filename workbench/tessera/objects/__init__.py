# SPDX-License-Identifier: MIT
"""Document objects. Class paths and property names are stored in users' files and never change."""
