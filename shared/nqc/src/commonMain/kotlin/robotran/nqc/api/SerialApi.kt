package robotran.nqc.api

internal val SERIAL_API = api(NqcApiGroup.SERIAL) {
    function(
        "SetSerialComm(const int &settings)",
        "Set(@(0x210011), settings);",
        ApiHelp(
            "Sets speed and carrier of the infrared light, such as SERIAL_COMM_4800.",
            "Stellt Tempo und Träger des Infrarotlichts ein, etwa SERIAL_COMM_4800.",
            "Ajusta velocidad y portadora de los infrarrojos, como SERIAL_COMM_4800.",
        ),
        targets = SECOND,
    )
    function(
        "SetSerialPacket(const int &settings)",
        "Set(@(0x210010), settings);",
        ApiHelp(
            "Sets what a packet of bytes has around it, such as SERIAL_PACKET_CHECKSUM.",
            "Stellt ein, was ein Paket von Bytes umgibt, etwa SERIAL_PACKET_CHECKSUM.",
            "Ajusta qué rodea a un paquete de bytes, como SERIAL_PACKET_CHECKSUM.",
        ),
        targets = SECOND,
    )
    function(
        "SetSerialData(const int n, const int &value)",
        "Set(@(0x210000 + n), value);",
        ApiHelp(
            "Sets byte 0 to 15 of the packet to send.",
            "Setzt Byte 0 bis 15 des Pakets, das gesendet wird.",
            "Pone el byte 0 a 15 del paquete que se envía.",
        ),
        targets = SECOND,
    )
    function(
        "SendSerial(const int first, const int count)",
        "asm { 0xc2, first, count };",
        ApiHelp("Sends bytes of the packet.", "Sendet Bytes des Pakets.", "Envía bytes del paquete."),
        targets = SECOND,
    )
    function(
        "InitSpybotComm()",
        "SetSerialPacket(0); SetSerialComm(7);",
        ApiHelp(
            "Prepares the infrared light for a Spybot.",
            "Bereitet das Infrarotlicht für einen Spybot vor.",
            "Prepara los infrarrojos para un Spybot.",
        ),
        targets = SECOND,
    )
    function(
        "InitRCComm()",
        "SetSerialPacket(0); SetSerialComm(7);",
        ApiHelp(
            "Prepares the infrared light for a remote-controlled toy.",
            "Bereitet das Infrarotlicht für ein ferngesteuertes Spielzeug vor.",
            "Prepara los infrarrojos para un juguete con mando.",
        ),
        targets = SECOND,
    )
    value(
        "SerialData(n)",
        "@(0x210000 + (n))",
        ApiHelp("Byte n of the packet.", "Byte n des Pakets.", "El byte n del paquete."),
        SECOND,
    )
    value(
        "SerialPacket()",
        "@(0x210010)",
        ApiHelp(
            "The setting of SetSerialPacket.",
            "Die Einstellung von SetSerialPacket.",
            "El ajuste de SetSerialPacket.",
        ),
        SECOND,
    )
    value(
        "SerialComm()",
        "@(0x210011)",
        ApiHelp("The setting of SetSerialComm.", "Die Einstellung von SetSerialComm.", "El ajuste de SetSerialComm."),
        SECOND,
    )
    constants(
        "SERIAL_COMM_DEFAULT=0 SERIAL_COMM_4800=1 SERIAL_COMM_76KHZ=2 SERIAL_COMM_DUTY25=4",
        ApiHelp("A setting for SetSerialComm.", "Eine Einstellung für SetSerialComm.", "Un ajuste de SetSerialComm."),
        SECOND,
    )
    constants(
        "SERIAL_PACKET_DEFAULT=0 SERIAL_PACKET_PREAMBLE=1 SERIAL_PACKET_NEGATED=2 SERIAL_PACKET_CHECKSUM=4 " +
            "SERIAL_PACKET_RCX=3",
        ApiHelp(
            "A setting for SetSerialPacket.",
            "Eine Einstellung für SetSerialPacket.",
            "Un ajuste de SetSerialPacket.",
        ),
        SECOND,
    )
}
