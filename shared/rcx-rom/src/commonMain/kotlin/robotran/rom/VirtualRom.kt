package robotran.rom

/**
 * The ROM as programs and the firmware see it: checks a call, lets the routine do its work and enters it in the [log].
 *
 * @param routines the modelled routines by address; the others of [RomTable] are reported as not modelled.
 * @param clock the brick's milliseconds.
 */
internal class VirtualRom(
    override val memory: RcxMemory,
    private val log: RomLog,
    private val routines: Map<Int, RomRoutine>,
    private val sensors: Sensors,
    private val clock: () -> Long,
) : Rom {
    override val milliseconds: Long get() = clock()

    override fun call(call: RomCall, sourceLine: Int) {
        val effect = perform(call)
        log.add(RomLogEntry(milliseconds, call, effect.meaning, sourceLine, effect.outcome))
    }

    override fun readSensor(port: Int, request: SensorRequest): Int = sensors.value(port, request)

    override fun setSensorTypeAndMode(port: Int, type: Int, mode: Int) = sensors.setTypeAndMode(port, type, mode)

    private fun perform(call: RomCall): RomEffect {
        val signature = RomTable.find(call.address)
            ?: return RomEffect("nothing happens, no routine is known here", RomOutcome.UNKNOWN_ROUTINE)
        val routine = routines[call.address]
            ?: return RomEffect("nothing happens, ${signature.name} is not modelled", RomOutcome.NOT_MODELLED)
        val arguments = call.arguments.map { it and WORD }
        return refusal(signature, arguments) ?: routine(arguments)
    }

    private fun refusal(signature: RomSignature, arguments: List<Int>): RomEffect? {
        val needed = signature.parameters.size
        val group = signature.codeGroup
        return when {
            arguments.size < needed -> refused(signature, "needs $needed arguments, not ${arguments.size}")
            group == null || arguments[0] shr BYTE_BITS == group -> null
            else -> refused(signature, "wants a code that begins with 0x${group.toString(radix = 16)}")
        }
    }

    private fun refused(signature: RomSignature, reason: String) =
        RomEffect("nothing happens, ${signature.name} $reason", RomOutcome.WRONG_ARGUMENTS)

    private companion object {
        const val WORD = 0xFFFF
        const val BYTE_BITS = 8
    }
}
