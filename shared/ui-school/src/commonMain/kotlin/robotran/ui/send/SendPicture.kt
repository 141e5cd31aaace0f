package robotran.ui.send

import androidx.compose.foundation.Canvas
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.scale
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.platform.testTag
import robotran.tower.TowerError
import robotran.tower.port.OpenFailure
import robotran.ui.school.tags.SendTags
import robotran.uikit.*
import robotran.workshop.state.SendError
import robotran.workshop.state.SendStep

/** A small picture of what happens, or of what to do. */
enum class SendPicture(val draw: DrawScope.(RobotranColours) -> Unit) {
    /** A program, and a line of it in red. */
    MISTAKE({ drawError(it) }),
    PROGRAM({ drawProgramToBrick(it) }),

    /** A computer with a tower, from which nothing goes. */
    NO_TOWER({ drawNoTower(it) }),
    PLUG_IN({ drawPlugIn(it) }),
    SENDING({ drawSending(it) }),
    DONE({ drawDone(it) }),
    BRICK_OFF({ drawBrickOff(it) }),
    OUT_OF_SIGHT({ drawOutOfSight(it) }),
    BATTERIES_LOW({ drawBatteriesLow(it) }),
    WRONG_FIRMWARE({ drawWrongFirmware(it) }),
    NO_ROOM({ drawNoRoom(it) }),
    UNPLUGGED({ drawUnplugged(it) }),
    TOWER_ASLEEP({ drawTowerAsleep(it) }),

    /** The tower behind a lock: another program, the system or the pupil keeps the app from it. */
    LOCKED({ drawLocked(it) }),
    ;

    companion object {
        /** The pictures are drawn in these units. */
        const val WIDTH = 240f
        const val HEIGHT = 120f
    }
}

@Composable
fun SendPictureView(picture: SendPicture, modifier: Modifier = Modifier) = StepPicture(picture.draw, modifier)

/** What [draw] draws in the middle, as large as its place allows. For screen readers the sentence says the same. */
@Composable
internal fun StepPicture(draw: DrawScope.(RobotranColours) -> Unit, modifier: Modifier = Modifier) =
    SmallStepPicture(draw, modifier.testTag(SendTags.SEND_PICTURE))

/** The same beside a sentence of a step that has several. */
@Composable
internal fun SmallStepPicture(draw: DrawScope.(RobotranColours) -> Unit, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    Canvas(modifier) {
        val factor = minOf(size.width / SendPicture.WIDTH, size.height / SendPicture.HEIGHT)
        translate((size.width - SendPicture.WIDTH * factor) / 2, (size.height - SendPicture.HEIGHT * factor) / 2) {
            scale(factor, Offset.Zero) { draw(colours) }
        }
    }
}

internal fun pictureOf(step: SendStep): SendPicture = when (step) {
    SendStep.Building, is SendStep.ChoosingSlot -> SendPicture.PROGRAM
    is SendStep.HasErrors -> SendPicture.MISTAKE
    SendStep.NoCompiler, SendStep.CompilerFailed -> SendPicture.MISTAKE
    SendStep.NoTowers -> SendPicture.NO_TOWER
    is SendStep.ChoosingTower -> SendPicture.PLUG_IN
    SendStep.Checking, is SendStep.Sending -> SendPicture.SENDING
    is SendStep.ReadingDatalog, is SendStep.Datalog -> SendPicture.SENDING
    is SendStep.NeedsFirmware, is SendStep.Cancelled -> SendPicture.WRONG_FIRMWARE
    is SendStep.Done -> SendPicture.DONE
    is SendStep.Watching -> if (step.isOver) SendPicture.UNPLUGGED else SendPicture.SENDING
    is SendStep.Failed -> pictureOf(step.error)
}

private fun pictureOf(error: SendError): SendPicture = when (error) {
    is SendError.OfPort -> if (error.failure == OpenFailure.GONE) SendPicture.UNPLUGGED else SendPicture.LOCKED

    is SendError.OfTower -> when (error.error) {
        TowerError.TowerGone -> SendPicture.UNPLUGGED
        TowerError.TowerSilent -> SendPicture.TOWER_ASLEEP
        TowerError.BrickSilent -> SendPicture.BRICK_OFF
        TowerError.BadConnection -> SendPicture.OUT_OF_SIGHT
        is TowerError.BatteryLow -> SendPicture.BATTERIES_LOW
        is TowerError.TooLarge -> SendPicture.NO_ROOM
        is TowerError.NoLejos, TowerError.NoLegoFirmware -> SendPicture.WRONG_FIRMWARE
        is TowerError.LegoFirmwareTooOld, TowerError.FirmwareRefused -> SendPicture.WRONG_FIRMWARE
    }
}
