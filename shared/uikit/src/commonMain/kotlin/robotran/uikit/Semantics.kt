package robotran.uikit

import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics

/** Screen readers say [name] of this. */
fun Modifier.named(name: String): Modifier = semantics { contentDescription = name }

/** Screen readers find this as a heading. */
fun Modifier.heading(): Modifier = semantics { heading() }

/** Screen readers say this when it changes, once they have nothing else to say. */
fun Modifier.announced(): Modifier = semantics { liveRegion = LiveRegionMode.Polite }
