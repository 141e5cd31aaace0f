package robotran.ui.world

import androidx.compose.foundation.layout.Box
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.role
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.AppMenu
import robotran.ui.parts.RadioMark
import robotran.ui.resources.Res
import robotran.ui.resources.space_camera
import robotran.ui.resources.space_camera_eye
import robotran.ui.resources.space_camera_follow
import robotran.ui.resources.space_camera_orbit
import robotran.ui.theme.TextSizes
import robotran.workshop.state.CameraKind

/** A button that opens the list of cameras of the 3D view. */
@Composable
internal fun CameraMenu(chosen: CameraKind, onChoice: (CameraKind) -> Unit) {
    var open by remember { mutableStateOf(false) }
    Box {
        SheetButton(SheetIcons.CAMERA, stringResource(Res.string.space_camera), "space-camera") { open = true }
        AppMenu(open, { open = false }) {
            for (kind in CameraKind.entries) {
                DropdownMenuItem(
                    text = { Text(stringResource(kind.words), fontSize = TextSizes.BODY) },
                    onClick = {
                        open = false
                        onChoice(kind)
                    },
                    modifier = Modifier.testTag("camera-${kind.name.lowercase()}").semantics {
                        role = Role.RadioButton
                        selected = kind == chosen
                    },
                    leadingIcon = { RadioMark(kind == chosen) },
                )
            }
        }
    }
}

internal val CameraKind.words: StringResource
    get() = when (this) {
        CameraKind.ORBIT -> Res.string.space_camera_orbit
        CameraKind.FOLLOW -> Res.string.space_camera_follow
        CameraKind.ROBOT_EYE -> Res.string.space_camera_eye
    }
