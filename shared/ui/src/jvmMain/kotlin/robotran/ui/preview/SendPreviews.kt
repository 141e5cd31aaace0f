package robotran.ui.preview

import androidx.compose.desktop.ui.tooling.preview.Preview
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.tower.TowerError
import robotran.tower.TransferProgress
import robotran.ui.send.SendCard
import robotran.ui.send.SendPicture
import robotran.ui.send.SendPictureView
import robotran.workshop.state.SendError
import robotran.workshop.state.SendState
import robotran.workshop.state.SendStep
import robotran.workshop.state.Transfer

@Preview
@Composable
internal fun SendingPreview() = SendCardPreview(
    SendStep.Sending(
        Transfer.PROGRAM,
        TransferProgress(confirmedBlocks = 7, totalBlocks = 25, repeats = 0, secondsLeft = 36),
    ),
)

@Preview
@Composable
internal fun SendingFailedPreview() = SendCardPreview(SendStep.Failed(SendError.OfTower(TowerError.BrickSilent)))

@Preview
@Composable
internal fun SendPicturesPreview() = PreviewWorkshop {
    Column {
        for (row in SendPicture.entries.chunked(PICTURES_A_ROW)) {
            Row { for (picture in row) SendPictureView(picture, Modifier.size(200.dp, 100.dp)) }
        }
    }
}

@Composable
private fun SendCardPreview(step: SendStep) = PreviewWorkshop { SendCard(SendState("square.robo", step), onEvent = {}) }

private const val PICTURES_A_ROW = 5
