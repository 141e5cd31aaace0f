package robotran.microbitlink

/**
 * The generations of the board.
 *
 * @property universalId what begins its part of a universal hex.
 */
enum class MicrobitBoard(internal val universalId: Int) {
    V1(0x9900),
    V2(0x9903),
    ;

    companion object {
        /** The board with the number [id], the first four digits of its serial number; null if it is no micro:bit. */
        fun ofId(id: Int): MicrobitBoard? = when (id) {
            in FIRST_IDS -> V1
            in SECOND_IDS -> V2
            else -> null
        }

        private val FIRST_IDS = 0x9900..0x9901
        private val SECOND_IDS = 0x9903..0x9906
    }
}
