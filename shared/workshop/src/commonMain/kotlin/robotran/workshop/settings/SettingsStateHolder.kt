package robotran.workshop.settings

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.CoroutineScope
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import robotran.language.Language
import robotran.projects.siteAddress
import robotran.workshop.event.SettingsEvent
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.platform.Platform
import robotran.workshop.platform.appLanguage
import robotran.workshop.service.Preferences
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RoomEvents
import robotran.workshop.service.SerialWriteQueue
import robotran.workshop.service.WindowRoomEvent
import robotran.workshop.state.PaneSizes
import robotran.workshop.state.Settings
import robotran.workshop.state.WindowForm

/** Holds the [Settings] of this machine. */
class SettingsStateHolder(
    private val platform: Platform,
    scope: CoroutineScope,
    first: Settings,
    private val events: RoomEvents,
) : Preferences {
    var state: Settings by mutableStateOf(first)
        private set

    /** Whether the settings page is shown. */
    var shown: Boolean by mutableStateOf(false)
        private set

    /** Whether that page opens at [Settings.site]. */
    var siteRequested: Boolean by mutableStateOf(false)
        private set

    private val writes = SerialWriteQueue(scope)

    override val settings: Settings get() = state
    override val language: Language get() = appLanguage(state.language)
    override val hasLessMotion: Boolean get() = state.lessMotion ?: platform.prefersLessMotion

    fun on(event: RoomEvent) {
        if (event == WindowRoomEvent.PagesLeft) show(page = false, atSite = false)
    }

    fun handle(event: SettingsEvent) {
        when (event) {
            is SettingsEvent.SettingsChanged -> change(event.settings)
            is SettingsEvent.WordsChosen -> change(state.copy(hasEnglishWords = event.inEnglish))
            is SettingsEvent.SoundSwitched -> change(state.copy(soundOn = event.on))
            is SettingsEvent.ProgramShareChosen -> resize(event.form) { copy(programShare = event.share).within() }
            is SettingsEvent.BrickSizeChosen -> resize(event.form) { copy(isBrickWhole = event.isWhole) }
            is SettingsEvent.SettingsShown -> show(event.shown, atSite = false)
            SettingsEvent.SiteRequested -> show(true, atSite = true)
        }
    }

    /** Waits until all changes are stored. */
    suspend fun saveNow() = writes.finish()

    private fun resize(form: WindowForm, sizes: PaneSizes.() -> PaneSizes) =
        change(state.copy(panes = state.panes.with(form, state.panes[form].sizes())))

    private fun show(page: Boolean, atSite: Boolean) {
        shown = page
        siteRequested = atSite
    }

    override fun change(settings: Settings) {
        if (settings == state) return
        val before = language to words
        state = settings
        writes.add { platform.store.write(NAME, JSON.encodeToString(Settings.serializer(), settings)) }
        events.publish(WindowRoomEvent.SettingsChanged(settings))
        if (language to words != before) events.publish(WindowRoomEvent.LanguageChanged(language))
    }

    companion object {
        private const val NAME = "settings"

        /** An unknown word, such as one of a newer Robotran, reads as the default. */
        private val JSON = Json {
            ignoreUnknownKeys = true
            coerceInputValues = true
        }

        /** The settings stored in [store]; [first] if there are none, the defaults if they are unreadable. */
        suspend fun readFrom(store: KeyValueStore, first: Settings = Settings()): Settings {
            val text = store.read(NAME) ?: return first
            return try {
                JSON.decodeFromString(Settings.serializer(), text).within()
            } catch (_: SerializationException) {
                Settings()
            } catch (_: IllegalArgumentException) {
                Settings()
            }
        }

        private fun Settings.within() = copy(
            textScale = textScale.coerceIn(1f, 2f),
            codeSize = codeSize.coerceIn(10f, 40f),
            site = siteAddress(site).orEmpty(),
            panes = panes.within(),
        )
    }
}
