package robotran.nqc.api

/**
 * Messages to Spybots and remote-controlled toys, byte by byte. A packet begins at byte 0 for a Spybot, at 7 for its
 * remote control, at 9 for a call whether anybody is there, and at 11 for a toy. The last part makes the sum 0.
 */
internal val REMOTE_API = api(NqcApiGroup.SERIAL) {
    spybots()
    spybotControl()
    spybotPing()
    toys()
    remoteConstants()
}

private fun ApiBuilder.spybots() {
    val message = "const int &mode, const int &id, const int &address, const int &command, " +
        "const int &high, const int &low"
    function(
        "SetSpybotMessage($message)",
        "SetSerialData(0, mode); SetSerialData(1, id); SetSerialData(2, address); SetSerialData(3, command); " +
            "SetSerialData(4, high); SetSerialData(5, low); " +
            "SetSerialData(6, 0 - mode - id - address - command - high - low);",
        ApiHelp(
            "Prepares a message to a Spybot.",
            "Bereitet eine Nachricht an einen Spybot vor.",
            "Prepara un mensaje para un Spybot.",
        ),
        targets = SECOND,
    )
    val send = ApiHelp(
        "Sends the message to a Spybot.",
        "Schickt die Nachricht an einen Spybot.",
        "Envía el mensaje a un Spybot.",
    )
    function("SendSpybotMsg()", "SendSerial(0, 7);", send, targets = SECOND)
    function(
        "SendSpybotMessage($message)",
        "InitSpybotComm(); SetSpybotMessage(mode, id, address, command, high, low); SendSpybotMsg();",
        send,
        targets = SECOND,
    )
}

private fun ApiBuilder.spybotControl() {
    val set = ApiHelp(
        "Prepares a press of a button of a Spybot's remote control.",
        "Bereitet einen Tastendruck der Fernbedienung eines Spybots vor.",
        "Prepara una pulsación del mando de un Spybot.",
    )
    val send = ApiHelp(
        "Sends a press of a button of a Spybot's remote control.",
        "Sendet einen Tastendruck der Fernbedienung eines Spybots.",
        "Envía una pulsación del mando de un Spybot.",
    )
    function(
        "SetSpybotCtrlMessage(const int &id, const int &button)",
        "SetSerialData(7, 0x90 + id); " +
            "SetSerialData(8, (button * 16) + ((0 - ((0x90 + id) / 16) - (0x90 + id) - button) & 0x0f));",
        set,
        targets = SECOND,
    )
    function("SendSpybotCtrlMsg()", "SendSerial(7, 2);", send, targets = SECOND)
    function(
        "SendSpybotCtrlMessage(const int &id, const int &button)",
        "InitSpybotComm(); SetSpybotCtrlMessage(id, button); SendSpybotCtrlMsg();",
        send,
        targets = SECOND,
    )
}

private fun ApiBuilder.spybotPing() {
    val set = ApiHelp(
        "Prepares a call that tells Spybots who is there.",
        "Bereitet einen Ruf vor, der Spybots sagt, wer da ist.",
        "Prepara una llamada que dice a los Spybots quién está ahí.",
    )
    val send = ApiHelp("Tells Spybots who is there.", "Sagt Spybots, wer da ist.", "Dice a los Spybots quién está ahí.")
    function(
        "SetSpybotCtrlPingMessage(const int &id)",
        "SetSerialData(9, 0x90 + id); SetSerialData(10, (0 - ((0x90 + id) / 16) - (0x90 + id)) & 0x0f);",
        set,
        targets = SECOND,
    )
    function("SendSpybotCtrlPingMsg()", "SendSerial(9, 2);", send, targets = SECOND)
    function(
        "SendSpybotCtrlPingMessage(const int &id)",
        "InitSpybotComm(); SetSpybotCtrlPingMessage(id); SendSpybotCtrlPingMsg();",
        send,
        targets = SECOND,
    )
    function(
        "SetSpybotPing(const int &link, const int &id, const int &info)",
        "SetSerialData(9, 0x80 + (link & 7)); SetSerialData(10, id); SetSerialData(11, info); " +
            "SetSerialData(12, 0 - (0x80 + (link & 7)) - id - info);",
        set,
        targets = SECOND,
    )
    function("SendSpybotPingMsg()", "SendSerial(9, 4);", send, targets = SECOND)
    function(
        "SendSpybotPing(const int &link, const int &id, const int &info)",
        "InitSpybotComm(); SetSpybotPing(link, id, info); SendSpybotPingMsg();",
        send,
        targets = SECOND,
    )
}

private fun ApiBuilder.toys() {
    function(
        "SetRCMessage(const int &channel, const int &left, const int &right)",
        "SetSerialData(11, channel + left); " +
            "SetSerialData(12, (right * 16) + ((0 - right - left - (channel / 16)) & 0x0f));",
        ApiHelp(
            "Prepares a command to both motors of a remote-controlled toy.",
            "Bereitet einen Befehl an beide Motoren eines ferngesteuerten Spielzeugs vor.",
            "Prepara una orden para los dos motores de un juguete con mando.",
        ),
        targets = SECOND,
    )
    val send = ApiHelp(
        "Sends a command to a remote-controlled toy.",
        "Sendet einen Befehl an ein ferngesteuertes Spielzeug.",
        "Envía una orden a un juguete con mando.",
    )
    function("SendRCMsg()", "SendSerial(11, 2);", send, targets = SECOND)
    function(
        "SendRCMessage(const int &channel, const int &left, const int &right)",
        "InitRCComm(); SetRCMessage(channel, left, right); SendRCMsg();",
        send,
        targets = SECOND,
    )
}

private fun ApiBuilder.remoteConstants() {
    constants(
        "SERIAL_COMM_RCX=0 SERIAL_COMM_RC=7 SERIAL_COMM_SPYBOT=7 SERIAL_PACKET_RC=0 SERIAL_PACKET_SPYBOT=0",
        ApiHelp(
            "A setting of the infrared light.",
            "Eine Einstellung des Infrarotlichts.",
            "Un ajuste de los infrarrojos.",
        ),
        SECOND,
    )
    constants(
        "UART_BOT=0 UART_CTRL=7 UART_PING=9 UART_RC=11",
        ApiHelp(
            "The first byte of a packet.",
            "Das erste Byte eines Pakets.",
            "El primer byte de un paquete.",
        ),
        SECOND,
    )
    constants(
        "MSG_DIRECT=0x88 MSG_LINKCAST=0x89 MSG_BROADCAST=0x8a",
        ApiHelp("Who gets a message.", "Wer eine Nachricht bekommt.", "Quién recibe un mensaje."),
        SECOND,
    )
    constants(
        "SPY_CTRL_BTN_1=1 SPY_CTRL_BTN_2=2 SPY_CTRL_BTN_3=3 SPY_CTRL_BTN_4=4 SPY_CTRL_BTN_5=5 SPY_CTRL_RCX_1=6 " +
            "SPY_CTRL_RCX_2=7 SPY_CTRL_RCX_3=8 SPY_CTRL_RCX_4=9 SPY_CTRL_RCX_5=10 SPY_CTRL_RCX_6=11 " +
            "SPY_CTRL_RCX_7=12 SPY_CTRL_RCX_8=13",
        ApiHelp(
            "A button of a Spybot's remote control.",
            "Eine Taste der Fernbedienung eines Spybots.",
            "Un botón del mando de un Spybot.",
        ),
        SECOND,
    )
    constants(
        "RC_CHANNEL_1=0x50 RC_CHANNEL_2=0x60 RC_CHANNEL_3=0x70 RC_CMD_FLOAT=0 RC_CMD_FWD=7 RC_CMD_OFF=8 RC_CMD_REV=15",
        ApiHelp(
            "A channel or a command of a toy.",
            "Ein Kanal oder Befehl eines Spielzeugs.",
            "Un canal o una orden de un juguete.",
        ),
        SECOND,
    )
    constants(
        "ID_NONE=0 ID_CTRL_1=1 ID_CTRL_2=2 ID_CTRL_3=3 ID_CTRL_4=4 ID_CTRL_5=5 ID_CTRL_6=6 ID_PC=7 ID_BOT_MIN=8 " +
            "ID_BOT_MAX=255",
        ApiHelp("Who is who among Spybots.", "Wer unter Spybots wer ist.", "Quién es quién entre los Spybots."),
        SECOND,
    )
    constants(
        "CMD_TYPE_MASK=0xf0 CMD_TYPE_GAME=0x10 CMD_TYPE_FIRE=0x20 CMD_TYPE_REACT_TO=0x30 CMD_TYPE_TELL=0x40 " +
            "CMD_TYPE_USER=0x50 CMD_TYPE_SPARE=0x60 CMD_TYPE_VLL=0x70 CMD_GAME_START=0x10 CMD_GAME_COMMAND=0x11 " +
            "CMD_GAME_GETVAR=0x12 CMD_GAME_VALUE=0x13 CMD_GAME_WIN=0x14 CMD_GAME_LOSE=0x15 CMD_GAME_BLINK=0x16 " +
            "CMD_GAME_GIVE=0x17 CMD_GAME_TAKE=0x18 CMD_FROM_RCX2=0x1f CMD_FIRE_LASER=0x21 CMD_FIRE_SPINNER=0x22 " +
            "CMD_FIRE_ELECTRONET=0x23 CMD_SMART_BOMB=0x61",
        ApiHelp("A command to a Spybot.", "Ein Befehl an einen Spybot.", "Una orden para un Spybot."),
        SECOND,
    )
}
