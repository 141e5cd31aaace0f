package robotran.workshop.state

import androidx.compose.runtime.Immutable
import kotlinx.serialization.Serializable
import robotran.language.Language
import robotran.projects.ProgramView

/**
 * The settings of this machine.
 *
 * @property language the app language; null for the system language.
 * @property hasEnglishWords whether blocks, and programs that come with the app, have the words of English and not those
 * of the app language.
 * @property textScale the scale factor of all text, 1..2.
 * @property codeSize the font size of program text in sp, 10..40.
 * @property programView how Robolang programs are shown first: as chosen last.
 * @property isIn3D whether worlds are shown in perspective: as chosen last.
 * @property cameraKind from where they are then seen: as chosen last.
 * @property lessMotion whether animations are reduced; null for as the system is told.
 * @property tellsRuns whether each run is told in words when it ends.
 * @property hearsRun whether what a robot does can be heard, for those who cannot see the sheet.
 * @property panes the sizes of panes that the pupil chose on this machine.
 * @property site the base URL of links if the app has none of its own; empty if not set.
 */
@Immutable
@Serializable
data class Settings(
    val language: Language? = null,
    val hasEnglishWords: Boolean = false,
    val theme: AppTheme = AppTheme.SYSTEM,
    val textScale: Float = 1f,
    val codeSize: Float = DEFAULT_CODE_SIZE,
    val soundOn: Boolean = true,
    val hearsRun: Boolean = false,
    val programView: ProgramView = ProgramView.TEXT,
    val lessMotion: Boolean? = null,
    val tellsRuns: Boolean = false,
    val isIn3D: Boolean = false,
    val cameraKind: CameraKind = CameraKind.ORBIT,
    val site: String = "",
    val panes: WindowSizes = WindowSizes(),
) {
    companion object {
        const val DEFAULT_CODE_SIZE = 15f
    }
}

enum class AppTheme { SYSTEM, LIGHT, DARK, HIGH_CONTRAST, HIGH_CONTRAST_DARK }
