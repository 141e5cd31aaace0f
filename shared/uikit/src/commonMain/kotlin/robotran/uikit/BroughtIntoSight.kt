package robotran.uikit

import androidx.compose.foundation.ExperimentalFoundationApi
import androidx.compose.foundation.relocation.BringIntoViewRequester
import androidx.compose.foundation.relocation.bringIntoViewRequester
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Modifier
import androidx.compose.ui.composed
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.layout.onSizeChanged
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.IntSize

/**
 * Scrolls the parent by the min distance that shows this beyond the edge's [scrollHint], when [requested] becomes true,
 * or when it is and there is other [content].
 */
@OptIn(ExperimentalFoundationApi::class)
fun Modifier.broughtIntoSight(requested: Boolean, content: Any? = Unit): Modifier = composed {
    val requester = remember { BringIntoViewRequester() }
    var size by remember { mutableStateOf(IntSize.Zero) }
    val margin = with(LocalDensity.current) { SCROLL_HINT_DEPTH.toPx() }
    LaunchedEffect(requested, content) {
        if (!requested) return@LaunchedEffect
        // It has its final position only after layout.
        withFrameNanos { }
        requester.bringIntoView(Rect(-margin, -margin, size.width + margin, size.height + margin))
    }
    onSizeChanged { size = it }.bringIntoViewRequester(requester)
}
