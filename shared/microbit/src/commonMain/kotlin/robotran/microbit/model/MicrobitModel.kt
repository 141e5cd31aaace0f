package robotran.microbit.model

import robotran.brick.kind.BrickKind

/**
 * The micro:bits that run MicroPython. A row holds the facts of a board, from the source of MicroPython 1.9.2 (V1) and
 * 1.18 (V2) for it unless said otherwise.
 *
 * @property kind the same among all bricks.
 * @property fileBytes room for its files.
 * @property heapBytes memory for programs and what they keep.
 * @property hasSpeaker whether it has a loudspeaker; without one it needs a buzzer on a pin.
 * @property buttons those that it has.
 * @property hasMicrophone whether it hears how loud it is.
 * @property hasOnePulsePeriod whether the pulses on all pins have one period, so that a tone changes that of servos.
 * @property statementMicroseconds about how long a statement takes (estimate).
 */
enum class MicrobitModel(
    val kind: BrickKind,
    val fileBytes: Int,
    val heapBytes: Int,
    val hasSpeaker: Boolean,
    val buttons: List<MicrobitButton>,
    val hasMicrophone: Boolean,
    val hasOnePulsePeriod: Boolean,
    val statementMicroseconds: Int,
) {
    V1(
        BrickKind.MICROBIT_V1,
        fileBytes = 28_672,
        heapBytes = 10_240,
        hasSpeaker = false,
        buttons = listOf(MicrobitButton.A, MicrobitButton.B),
        hasMicrophone = false,
        hasOnePulsePeriod = true,
        statementMicroseconds = 100,
    ),
    V2(
        BrickKind.MICROBIT,
        fileBytes = 20_480,
        heapBytes = 65_536,
        hasSpeaker = true,
        buttons = MicrobitButton.entries,
        hasMicrophone = true,
        hasOnePulsePeriod = false,
        statementMicroseconds = 20,
    ),
    ;

    companion object {
        /** The board of this kind; null if [kind] is none. */
        fun of(kind: BrickKind): MicrobitModel? = entries.find { it.kind == kind }
    }
}
