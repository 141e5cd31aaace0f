package robotran.ui.settings

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.input.KeyboardType
import robotran.projects.siteAddress
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.uikit.*

/** The base URL of links. Passes only valid URLs, or an empty text, to [onSite]. */
@Composable
internal fun SiteField(site: String, requested: Boolean, onSite: (String) -> Unit) {
    val colours = LocalRobotranColours.current
    var text by remember { mutableStateOf(site) }
    val isWrong = text.isNotBlank() && siteAddress(text) == null
    val focus = remember { FocusRequester() }
    LaunchedEffect(requested) { if (requested) focus.requestFocus() }
    TextField(
        text,
        {
            text = it
            val address = siteAddress(it)
            if (address != null || it.isBlank()) onSite(address.orEmpty())
        },
        Modifier.fillMaxWidth().broughtIntoSight(requested).focusRequester(focus).testTag(ScreenTags.SITE),
        ScreenTexts.settingsSite(spoken),
        keyboard = KeyboardOptions(keyboardType = KeyboardType.Uri, autoCorrectEnabled = false),
        extras = FieldExtras(isWrong) {
            Text(
                if (isWrong) ScreenTexts.settingsSiteWrong(spoken) else ScreenTexts.settingsSiteHelp(spoken),
                Modifier.testTag(if (isWrong) ScreenTags.SITE_WRONG else ScreenTags.SITE_HELP).announced(),
                TextStyles.small,
                color = if (isWrong) colours.error else colours.quiet,
            )
        },
    )
}
