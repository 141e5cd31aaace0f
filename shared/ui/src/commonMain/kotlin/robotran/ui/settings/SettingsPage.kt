package robotran.ui.settings

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.language.Language
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.uikit.*
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AppTheme
import robotran.workshop.state.Settings
import kotlin.math.roundToInt

/** The look and sound of the app on this machine. Changes apply at once. */
@Composable
internal fun SettingsPage(
    settings: Settings,
    siteRequested: Boolean,
    asksForSite: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
) {
    val change = { changed: Settings -> onEvent(SettingsEvent.SettingsChanged(changed)) }
    val scroll = rememberScrollState()
    val close = { onEvent(SettingsEvent.SettingsShown(false)) }
    Page(ScreenTexts.settingsTitle(spoken), ScreenTags.SETTINGS, close, scroll) {
        Column(Modifier.verticalScroll(scroll).padding(24.dp), Arrangement.spacedBy(28.dp)) {
            ChoiceOfOne(
                ScreenTexts.settingsLanguage(spoken),
                listOf(null to ScreenTexts.settingsLanguageMachine(spoken)) +
                    Language.entries.map { it to it.ownName },
                settings.language,
                ScreenTags.LANGUAGE,
            ) { change(settings.copy(language = it)) }
            val own = LocalLanguage.current
            if (own != Language.ENGLISH) {
                ChoiceOfOne(
                    ScreenTexts.settingsWords(spoken),
                    listOf(false to own.ownName, true to Language.ENGLISH.ownName),
                    settings.hasEnglishWords,
                    ScreenTags.WORDS,
                ) { onEvent(SettingsEvent.WordsChosen(it)) }
            }
            ChoiceOfOne(
                ScreenTexts.settingsTheme(spoken),
                AppTheme.entries.map { it to it.title(spoken) },
                settings.theme,
                ScreenTags.THEME,
            ) { change(settings.copy(theme = it)) }
            SizeSlider(
                ScreenTexts.settingsTextSize(spoken),
                settings.textScale,
                1f..2f,
                3,
                { "${(it * 100).roundToInt()} %" },
                ScreenTags.TEXT_SIZE,
            ) { change(settings.copy(textScale = it)) }
            SizeSlider(
                ScreenTexts.settingsCodeSize(spoken),
                settings.codeSize,
                10f..40f,
                0,
                { "${it.roundToInt()}" },
                ScreenTags.CODE_SIZE,
            ) { change(settings.copy(codeSize = it.roundToInt().toFloat())) }
            SwitchRow(ScreenTexts.settingsSound(spoken), settings.soundOn, ScreenTags.SOUND_SETTING) {
                change(settings.copy(soundOn = it))
            }
            HearingSettings(settings, onEvent)
            SwitchRow(ScreenTexts.settingsLessMotion(spoken), LocalLessMotion.current, ScreenTags.LESS_MOTION) {
                change(settings.copy(lessMotion = it))
            }
            SwitchRow(ScreenTexts.settingsTellRuns(spoken), settings.tellsRuns, ScreenTags.TELL_RUNS) {
                change(settings.copy(tellsRuns = it))
            }
            if (asksForSite) SiteField(settings.site, siteRequested) { change(settings.copy(site = it)) }
        }
    }
}

private val AppTheme.title: Label
    get() = when (this) {
        AppTheme.SYSTEM -> ScreenTexts::themeSystem
        AppTheme.LIGHT -> ScreenTexts::themeLight
        AppTheme.DARK -> ScreenTexts::themeDark
        AppTheme.HIGH_CONTRAST -> ScreenTexts::themeHighContrast
        AppTheme.HIGH_CONTRAST_DARK -> ScreenTexts::themeHighContrastDark
    }
