package robotran.tower

/** Something that a robot sends by itself. */
sealed interface ReceivedMessage {
    /** A message of one number, 0 to 255: `SendMessage` of LEGO's firmware, `Serial` or `Message` of leJOS. */
    data class Number(val value: Int) : ReceivedMessage

    /** A packet with any other opcode. [bytes] begin with it; the checksum is left out. */
    data class Packet(val bytes: List<Byte>) : ReceivedMessage

    /** Bytes that are no undamaged packet: noise, or a program that sends in a form of its own. */
    data class Raw(val bytes: List<Byte>) : ReceivedMessage
}
