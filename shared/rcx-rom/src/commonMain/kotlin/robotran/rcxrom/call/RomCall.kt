package robotran.rcxrom.call

/**
 * One call of a ROM routine, as `josx.platform.rcx.ROM.call` makes it.
 *
 * @property address start address of the routine, 0..0xFFFF.
 * @property arguments zero to four 16-bit values, each unsigned, 0..0xFFFF; pointers are addresses in [RcxMemory].
 */
data class RomCall(val address: Int, val arguments: List<Int>)
