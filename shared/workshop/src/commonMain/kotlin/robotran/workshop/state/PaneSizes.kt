package robotran.workshop.state

import androidx.compose.runtime.Immutable
import kotlinx.serialization.Serializable

/** The windows that show several panes; each has its own sizes of panes. */
enum class WindowForm {
    /** Higher than wide, such as a tablet in portrait. */
    UPRIGHT,

    /** A tablet in landscape, or a laptop. */
    ACROSS,

    /** A large screen. */
    BROAD,
}

/**
 * The sizes of panes that the pupil chose for one form of window.
 *
 * @property programShare the part of the width, or of the height, that the program has, in [SHARES]; null until it is
 * chosen.
 * @property isBrickWhole whether the brick is shown with all its buttons and ports; null until it is chosen.
 */
@Immutable
@Serializable
data class PaneSizes(val programShare: Float? = null, val isBrickWhole: Boolean? = null) {
    /** With a share that is possible, whatever a file says. */
    fun within(): PaneSizes = copy(programShare = programShare?.takeIf { it in SHARES })

    companion object {
        val SHARES = 0.05f..0.95f
    }
}

/** The sizes of panes of all forms of windows. */
@Immutable
@Serializable
data class WindowSizes(
    val upright: PaneSizes = PaneSizes(),
    val across: PaneSizes = PaneSizes(),
    val broad: PaneSizes = PaneSizes(),
) {
    operator fun get(form: WindowForm): PaneSizes = when (form) {
        WindowForm.UPRIGHT -> upright
        WindowForm.ACROSS -> across
        WindowForm.BROAD -> broad
    }

    /** The same with [sizes] for [form]. */
    fun with(form: WindowForm, sizes: PaneSizes): WindowSizes = when (form) {
        WindowForm.UPRIGHT -> copy(upright = sizes)
        WindowForm.ACROSS -> copy(across = sizes)
        WindowForm.BROAD -> copy(broad = sizes)
    }

    fun within(): WindowSizes = WindowSizes(upright.within(), across.within(), broad.within())
}
