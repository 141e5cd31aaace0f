package robotran.build

import org.gradle.api.Project

/**
 * What this build configures, from the system property `robotran.targets`: Kotlin's targets [jvm], [wasm] and
 * [android], and the modules that need [compose]. `gradlew` sets the property to what the requested tasks need.
 */
class Targets private constructor(private val names: Set<String>) {
    val jvm get() = "jvm" in names
    val wasm get() = "wasm" in names
    val android get() = "android" in names
    val compose get() = "compose" in names

    /** Whether nothing is left out that `check` needs: all but Android. */
    val isComplete get() = jvm && wasm && compose

    companion object {
        /** Also read by `settings.gradle.kts` and `gradle/build-logic/root/build.gradle.kts`. */
        private const val PROPERTY = "robotran.targets"

        fun of(project: Project): Targets = Targets(project.providers.systemProperty(PROPERTY).get().split(",").toSet())
    }
}
