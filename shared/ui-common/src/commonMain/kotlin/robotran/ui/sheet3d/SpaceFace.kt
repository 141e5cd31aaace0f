package robotran.ui.sheet3d

import robotran.scene3d.model.RobotFace
import robotran.ui.sheet.PenbotFace
import robotran.ui.sheet.PenbotMood

/** The face that the sheet shows, for a robot in perspective. */
internal fun spaceFace(face: PenbotFace) = RobotFace(
    face.gaze.x.toDouble(),
    face.gaze.y.toDouble(),
    when {
        face.lid >= SHUT -> RobotFace.Lids.SHUT
        face.mood == PenbotMood.SULKING -> RobotFace.Lids.HANGING
        face.mood == PenbotMood.GLAD -> RobotFace.Lids.RAISED
        else -> RobotFace.Lids.OPEN
    },
)

private const val SHUT = 0.5f
