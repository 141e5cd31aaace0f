package robotran.ui.texts

import robotran.brick.kind.BrickKind
import robotran.brick.kind.ByBrick
import robotran.uikit.*

/**
 * What the screens call a kind of brick and what it has.
 *
 * @property programIsFor says that a program is for this brick and not for that of the robot.
 * @property use gives the robot this brick.
 * @property send what brings a program onto a real one.
 * @property off what its picture says while it is off.
 * @property log the calls of its programs.
 * @property noCalls what is shown while there are none.
 * @property forgivingJava what Java forgives that a real one does not.
 */
class BrickLabels private constructor(
    val programIsFor: Label,
    val use: Label,
    val send: Label,
    val off: Label,
    val log: Label,
    val noCalls: Label,
    val forgivingJava: Label,
) {
    companion object {
        private fun ofRcx() = BrickLabels(
            programIsFor = NxtTexts::programForRcx,
            use = NxtTexts::programUseRcx,
            send = CommonTexts::sendToRobot,
            off = CommonTexts::brickOff,
            log = CommonTexts::tabLog,
            noCalls = CommonTexts::logEmpty,
            forgivingJava = CommonTexts::javaForgivingHelp,
        )

        private fun ofNxt() = BrickLabels(
            programIsFor = NxtTexts::programForNxt,
            use = NxtTexts::programUseNxt,
            send = CommonTexts::sendingKit,
            off = NxtTexts::off,
            log = NxtTexts::runTabCalls,
            noCalls = NxtTexts::runLogEmptyCalls,
            forgivingJava = CommonTexts::javaForgivingHelpNxt,
        )

        /** What is said about any hub with Pybricks, and about a micro:bit; [brick] has its name. */
        private fun ofOther(brick: BrickKind) = BrickLabels(
            programIsFor = { HubTexts.programIsFor(it, brick.label) },
            use = { HubTexts.use(it, brick.label) },
            send = CommonTexts::sendToRobot,
            off = CommonTexts::brickOff,
            log = NxtTexts::runTabCalls,
            noCalls = NxtTexts::runLogEmptyCalls,
            forgivingJava = CommonTexts::javaForgivingHelp,
        )

        private val LABELS = ByBrick { brick ->
            when (brick) {
                BrickKind.RCX -> ofRcx()
                BrickKind.NXT -> ofNxt()

                BrickKind.SPIKE_PRIME, BrickKind.SPIKE_ESSENTIAL, BrickKind.TECHNIC_HUB, BrickKind.EV3,
                BrickKind.NXT_PYBRICKS, BrickKind.MICROBIT, BrickKind.MICROBIT_V1,
                -> ofOther(brick)
            }
        }

        fun of(brick: BrickKind): BrickLabels = LABELS[brick]
    }
}
