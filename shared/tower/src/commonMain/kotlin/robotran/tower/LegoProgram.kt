package robotran.tower

/**
 * A program for LEGO's firmware.
 *
 * @property parts its subroutines and tasks in any order. A number may occur once among the tasks and once among the
 *   subroutines.
 */
data class LegoProgram(val parts: List<LegoProgramPart>)

/**
 * A task or a subroutine in bytecode.
 *
 * @property number tasks 0 to 9, of which 0 is the main task; subroutines 0 to 7.
 */
class LegoProgramPart(val kind: LegoPartKind, val number: Int, val code: ByteArray) {
    init {
        require(number in 0 until kind.count) { "there is no $kind $number" }
        require(code.size <= MAX_CODE_BYTES) { "${code.size} bytes of code" }
    }

    private companion object {
        /** Its length has two bytes. */
        const val MAX_CODE_BYTES = 0xFFFF
    }
}

/** @property count how many a slot has. */
enum class LegoPartKind(internal val count: Int) {
    TASK(LegoLimits.TASKS),
    SUBROUTINE(LegoLimits.SUBROUTINES),
}
