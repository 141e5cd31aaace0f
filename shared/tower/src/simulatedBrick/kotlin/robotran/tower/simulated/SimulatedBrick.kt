package robotran.tower.simulated

/**
 * An RCX as a tower sees it.
 *
 * @param firmware what answers at first: [SimulatedRom] for a brick without firmware, [SimulatedLejos],
 *   [SimulatedLegoFirmware], or [AliveOnly].
 */
class SimulatedBrick(firmware: SimulatedFirmware) {
    /** What answers now. */
    var firmware = firmware
        private set

    /** A brick that is off, or out of sight, hears nothing. */
    var isOn = true

    /** An opcode whose messages it does not answer; null for none. */
    var isDeafTo: Int? = null

    /** The undamaged messages that the brick has heard. */
    val messages = mutableListOf<ByteArray>()

    private val decoder = MessageDecoder()

    /** The answer, as it is sent, if [byte] completes a message that has one. */
    internal fun hear(byte: Byte): List<Byte>? {
        if (!isOn) return null
        val message = decoder.hear(byte) ?: return null
        if (opcodeOf(message) == isDeafTo) return null
        messages += message
        val reaction = firmware.handle(message)
        reaction.next?.let { firmware = it }
        return reaction.answer?.let(::framed)
    }
}

/** A firmware that is neither leJOS nor LEGO's: it answers that it is there, and nothing else. */
class AliveOnly : SimulatedFirmware {
    override fun handle(message: ByteArray): Reaction =
        if (opcodeOf(message) == 0x10) Reaction(answerTo(message)) else Reaction()
}
