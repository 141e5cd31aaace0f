package robotran.robolang.words

import robotran.brick.kind.BrickKind
import robotran.brick.kind.ByBrick

/**
 * What the language means on a kind of brick, apart from the words that need a [BrickFeature].
 *
 * @property keyword what the header calls the brick.
 * @property asksRobot whether `light` and other words read the sensor of that kind that the robot has, on whichever port.
 * @property hasShortNumbers whether whole numbers have 31 bits, and larger ones and divisions by 0 end a program.
 * @property waitsForOutput whether a program waits while a tone sounds or letters are shown.
 * @property rightBumperPort the port of the right bumper; that of the left one is 1.
 * @property lightPort the port of the light sensor, unless the header names another.
 * @property hasSeveralOfAKind whether the header can have sensors of the same kind on several ports.
 * @property takesButtonsOfOthers whether it takes the name of another brick's button for its own with the same purpose.
 * @property textLength the number of characters that it shows.
 * @property showsAscii whether it shows all of ASCII, not only letters, digits and a few signs.
 * @property freesLists whether it frees lists that are no longer in use.
 * @property dividesByShort whether it divides only by numbers of 16 bits.
 * @property rollsOn whether its wheels roll on when a program ends, so that the program stops them first.
 * @property waitsForSensors whether sensors need time until they measure.
 */
internal class BrickDialect private constructor(
    val keyword: Keyword,
    val rightBumperPort: Int,
    val lightPort: Int,
    val hasSeveralOfAKind: Boolean,
    val takesButtonsOfOthers: Boolean,
    val textLength: Int,
    val showsAscii: Boolean,
    val freesLists: Boolean,
    val dividesByShort: Boolean,
    val rollsOn: Boolean,
    val waitsForSensors: Boolean,
    val asksRobot: Boolean = false,
    val hasShortNumbers: Boolean = false,
    val waitsForOutput: Boolean = false,
) {
    fun shows(character: Char): Boolean = if (showsAscii) {
        character in ' '..'~'
    } else {
        character in 'a'..'z' || character in 'A'..'Z' || character in '0'..'9' || character in " -_"
    }

    companion object {
        private fun rcx() = BrickDialect(
            keyword = Keyword.RCX,
            rightBumperPort = 3,
            lightPort = 2,
            hasSeveralOfAKind = false,
            takesButtonsOfOthers = false,
            textLength = 5,
            showsAscii = false,
            freesLists = false,
            dividesByShort = true,
            rollsOn = false,
            waitsForSensors = false,
        )

        private fun nxt() = BrickDialect(
            keyword = Keyword.NXT,
            rightBumperPort = 2,
            lightPort = 3,
            hasSeveralOfAKind = true,
            takesButtonsOfOthers = true,
            textLength = 16,
            showsAscii = true,
            freesLists = true,
            dividesByShort = false,
            rollsOn = true,
            waitsForSensors = true,
        )

        private fun hub(keyword: Keyword, lightPort: Int) = BrickDialect(
            keyword,
            rightBumperPort = 2,
            lightPort,
            hasSeveralOfAKind = true,
            takesButtonsOfOthers = true,
            textLength = 100,
            showsAscii = true,
            freesLists = true,
            dividesByShort = false,
            rollsOn = true,
            waitsForSensors = false,
            asksRobot = true,
            hasShortNumbers = true,
            waitsForOutput = true,
        )

        private fun microbit() = BrickDialect(
            keyword = Keyword.MICROBIT,
            rightBumperPort = 2,
            lightPort = 1,
            hasSeveralOfAKind = true,
            takesButtonsOfOthers = true,
            textLength = 100,
            showsAscii = true,
            freesLists = true,
            dividesByShort = false,
            rollsOn = false,
            waitsForSensors = false,
            asksRobot = true,
        )

        private val DIALECTS = ByBrick { brick ->
            when (brick) {
                BrickKind.RCX -> rcx()
                BrickKind.NXT -> nxt()
                BrickKind.SPIKE_PRIME -> hub(Keyword.SPIKE, lightPort = 4)
                BrickKind.SPIKE_ESSENTIAL -> hub(Keyword.ESSENTIAL, lightPort = 2)
                BrickKind.TECHNIC_HUB -> hub(Keyword.TECHNIC, lightPort = 4)
                BrickKind.EV3 -> hub(Keyword.EV3, lightPort = 3)

                // Its programs are those of an NXT.
                BrickKind.NXT_PYBRICKS -> hub(Keyword.NXT, lightPort = 3)

                BrickKind.MICROBIT, BrickKind.MICROBIT_V1 -> microbit()
            }
        }

        fun of(brick: BrickKind): BrickDialect = DIALECTS[brick]
    }
}
