package robotran.ui.settings

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.language.Language
import robotran.ui.parts.Page
import robotran.ui.resources.*
import robotran.ui.theme.LocalLessMotion
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.AppTheme
import robotran.workshop.state.Settings
import kotlin.math.roundToInt

/** The look and sound of the app on this machine. Changes apply at once. */
@Composable
internal fun SettingsPage(
    settings: Settings,
    siteRequested: Boolean,
    asksForSite: Boolean,
    onEvent: (SettingsEvent) -> Unit,
) {
    val change = { changed: Settings -> onEvent(SettingsEvent.SettingsChanged(changed)) }
    val scroll = rememberScrollState()
    val close = { onEvent(SettingsEvent.SettingsShown(false)) }
    Page(stringResource(Res.string.settings_title), "settings", close, scroll) {
        Column(Modifier.verticalScroll(scroll).padding(24.dp), Arrangement.spacedBy(28.dp)) {
            ChoiceOfOne(
                stringResource(Res.string.settings_language),
                listOf(null to stringResource(Res.string.settings_language_machine)) +
                    Language.entries.map { it to it.ownName },
                settings.language,
                "language",
            ) { change(settings.copy(language = it)) }
            ChoiceOfOne(
                stringResource(Res.string.settings_theme),
                AppTheme.entries.map { it to stringResource(it.title) },
                settings.theme,
                "theme",
            ) { change(settings.copy(theme = it)) }
            SizeSlider(
                stringResource(Res.string.settings_text_size),
                settings.textScale,
                1f..2f,
                3,
                { "${(it * 100).roundToInt()} %" },
                "text-size",
            ) { change(settings.copy(textScale = it)) }
            SizeSlider(
                stringResource(Res.string.settings_code_size),
                settings.codeSize,
                10f..40f,
                0,
                { "${it.roundToInt()}" },
                "code-size",
            ) { change(settings.copy(codeSize = it.roundToInt().toFloat())) }
            SwitchRow(stringResource(Res.string.settings_sound), settings.soundOn, "sound-setting") {
                change(settings.copy(soundOn = it))
            }
            SwitchRow(stringResource(Res.string.settings_less_motion), LocalLessMotion.current, "less-motion") {
                change(settings.copy(lessMotion = it))
            }
            if (asksForSite) SiteField(settings.site, siteRequested) { change(settings.copy(site = it)) }
        }
    }
}

private val AppTheme.title: StringResource
    get() = when (this) {
        AppTheme.SYSTEM -> Res.string.theme_system
        AppTheme.LIGHT -> Res.string.theme_light
        AppTheme.DARK -> Res.string.theme_dark
        AppTheme.HIGH_CONTRAST -> Res.string.theme_high_contrast
        AppTheme.HIGH_CONTRAST_DARK -> Res.string.theme_high_contrast_dark
    }
