package robotran.android

import android.view.View
import android.view.ViewGroup
import androidx.core.view.children

/** Whether this view or a child keeps the screen on. */
internal fun View.isKeptOn(): Boolean = keepScreenOn || (this as? ViewGroup)?.children.orEmpty().any { it.isKeptOn() }

private fun Sequence<View>?.orEmpty(): Sequence<View> = this ?: emptySequence()
