package robotran.build

import org.gradle.api.Project
import org.gradle.api.tasks.testing.Test

/** Property tests try the same values in every build, so that one that passed does not fail elsewhere. */
internal object PropertyTests {
    /** `-PpropertySeed=N` lets a build try other values. */
    private const val SEED_PROPERTY = "propertySeed"
    private const val DEFAULT_SEED = "2005"

    fun configure(project: Project, test: Test) {
        test.systemProperty("kotest.proptest.default.seed", project.findProperty(SEED_PROPERTY) ?: DEFAULT_SEED)
        // A seed remembered in the home folder would make a build depend on the ones before.
        test.systemProperty("kotest.proptest.seed.write-failed", "false")
    }
}
