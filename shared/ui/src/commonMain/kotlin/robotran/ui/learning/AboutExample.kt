package robotran.ui.learning

import org.jetbrains.compose.resources.ExperimentalResourceApi
import org.jetbrains.compose.resources.StringResource
import robotran.language.ProgramLanguage
import robotran.ui.resources.*

/**
 * A one-sentence description of the example [name]. For `wall-bouncer.robo` and `WallBouncer.java` it is
 * `example_wall_bouncer`, unless the Java version has its own resource, whose name ends in `_java`, or in `_nxj` for an
 * NXT, or the one in NQC has one that ends in `_nqc`.
 */
@OptIn(ExperimentalResourceApi::class)
internal fun aboutExample(set: ExampleSet, name: String): StringResource {
    val stem = name.removeSuffix(set.language.extension)
    val words = if (set.language == ProgramLanguage.JAVA) {
        stem.replace(CAPITAL_INSIDE) { "_${it.value}" }
    } else {
        stem.replace('-', '_')
    }
    val key = "example_${words.lowercase()}"
    val own = when (set) {
        ExampleSet.ROBOLANG -> null
        ExampleSet.LEJOS -> Res.allStringResources["${key}_java"]
        ExampleSet.NQC -> Res.allStringResources["${key}_nqc"]
        ExampleSet.NXJ -> Res.allStringResources["${key}_nxj"]
    }
    return own ?: Res.allStringResources.getValue(key)
}

private val CAPITAL_INSIDE = Regex("\\B[A-Z]")
