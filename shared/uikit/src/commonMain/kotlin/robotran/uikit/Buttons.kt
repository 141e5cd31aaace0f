package robotran.uikit

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Button
import androidx.compose.material3.ButtonDefaults
import androidx.compose.material3.OutlinedButton
import androidx.compose.material3.Text
import androidx.compose.material3.TextButton
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp

/** The button for the recommended action. [help] is a description for screen readers. */
@Composable
fun PrimaryButton(
    text: String,
    tag: String,
    onClick: () -> Unit,
    modifier: Modifier = Modifier,
    help: String? = null,
) = Button(
    onClick = onClick,
    modifier = modifier.testTag(tag).semantics {
        help?.let { onClick(label = it, action = null) }
    }.focusRing(CORNER).large(),
    shape = RoundedCornerShape(CORNER),
    colors = ButtonDefaults.buttonColors(RobotranColours.YELLOW, RobotranColours.ON_YELLOW),
    contentPadding = PADDING,
) { Words(text) }

/** The button for another action. */
@Composable
fun SecondButton(text: String, tag: String, onClick: () -> Unit, modifier: Modifier = Modifier) = OutlinedButton(
    onClick = onClick,
    modifier = modifier.testTag(tag).focusRing(CORNER).large(),
    shape = RoundedCornerShape(CORNER),
    colors = ButtonDefaults.outlinedButtonColors(contentColor = LocalRobotranColours.current.onPane),
    border = BorderStroke(1.dp, LocalRobotranColours.current.quiet),
    contentPadding = PADDING,
) { Words(text) }

/** The button for a rare action. */
@Composable
fun QuietButton(
    text: String,
    tag: String,
    onClick: () -> Unit,
    enabled: Boolean = true,
    modifier: Modifier = Modifier,
) = TextButton(
    onClick = onClick,
    modifier = modifier.testTag(tag).focusRing(CORNER).large(),
    enabled = enabled,
    shape = RoundedCornerShape(CORNER),
    colors = ButtonDefaults.textButtonColors(contentColor = LocalRobotranColours.current.onPane),
    contentPadding = PADDING,
) { Words(text) }

/** The size of a button with [text], for measuring. */
@Composable
fun ButtonSize(text: String) = Box(Modifier.large().padding(PADDING), Alignment.Center) { Words(text) }

@Composable
private fun Words(text: String) =
    Text(text, fontSize = TextSizes.BODY, fontWeight = FontWeight.Medium, textAlign = TextAlign.Center)

private fun Modifier.large() = defaultMinSize(Dimensions.TARGET, Dimensions.TARGET)

private val CORNER = Corners.MEDIUM
private val PADDING = PaddingValues(horizontal = 16.dp, vertical = 8.dp)
