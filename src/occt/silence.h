// SPDX-License-Identifier: MIT
#pragma once

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_SequenceOfPrinters.hxx>

namespace tessera
{

/// OpenCASCADE reports to standard output; silent while this lives.
class Silence
{
public:
    Silence()
        : printers_(Message::DefaultMessenger()->Printers())
    {
        Message::DefaultMessenger()->ChangePrinters().Clear();
    }
    ~Silence() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

private:
    Message_SequenceOfPrinters printers_;
};

} // namespace tessera
