package robotran.build

import org.gradle.api.Project
import org.gradle.api.tasks.testing.Test

/** Property tests use a fixed seed, so that they have the same result in every build. */
object PropertyTests {
    /** `-PpropertySeed=N` selects another seed. */
    private const val SEED_PROPERTY = "propertySeed"
    private const val DEFAULT_SEED = "2005"

    fun configure(project: Project, test: Test) {
        test.systemProperty("kotest.proptest.default.seed", project.findProperty(SEED_PROPERTY) ?: DEFAULT_SEED)
        // A seed stored in the home folder would make a build depend on earlier ones.
        test.systemProperty("kotest.proptest.seed.write-failed", "false")
    }
}
