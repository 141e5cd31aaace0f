package robotran.rcxrom.call

/**
 * One call of a ROM routine, as `josx.platform.rcx.ROM.call` makes it.
 *
 * @property address where the routine begins, 0..0xFFFF.
 * @property arguments none to four 16-bit values, each as an unsigned number 0..0xFFFF; pointers are addresses in
 * [RcxMemory].
 */
data class RomCall(val address: Int, val arguments: List<Int>)
