package robotran.build

import org.gradle.api.Project
import org.gradle.api.logging.Logging
import org.gradle.api.provider.Provider
import org.gradle.api.services.BuildService
import org.gradle.api.services.BuildServiceParameters
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.testing.Test
import org.gradle.process.CommandLineArgumentProvider
import kotlin.random.Random

/**
 * Property tests use a fixed seed, so that they have the same result in every build; only [FuzzTests.TASK] uses a new one
 * each time. `-PpropertySeed=N` selects the seed of both.
 */
object PropertyTests {
    private const val SEED_PROPERTY = "propertySeed"
    private const val DEFAULT_SEED = "2005"

    fun configure(project: Project, test: Test) {
        // A seed stored in the home folder would make a build depend on earlier ones.
        test.systemProperty("kotest.proptest.seed.write-failed", "false")
        val chosen = project.findProperty(SEED_PROPERTY)
        if (chosen == null && test.name == FuzzTests.TASK) {
            useFreshSeed(project, test)
        } else {
            test.jvmArgs("-D$SEED=${chosen ?: DEFAULT_SEED}")
        }
    }

    private fun useFreshSeed(project: Project, test: Test) {
        val seed = project.gradle.sharedServices.registerIfAbsent("freshSeed", FreshSeed::class.java) {}
        test.usesService(seed)
        test.jvmArgumentProviders.add(SeedArgument(seed))
        test.outputs.upToDateWhen { false }
        test.outputs.doNotCacheIf("it tries other inputs each time") { true }
    }
}

private const val SEED = "kotest.proptest.default.seed"

/** One new seed for the whole build. */
internal abstract class FreshSeed : BuildService<BuildServiceParameters.None> {
    val seed: Int by lazy {
        Random.nextInt(0, Int.MAX_VALUE).also {
            Logging.getLogger(
                FreshSeed::class.java,
            ).quiet("Fuzz tests use the seed $it: -PpropertySeed=$it repeats them.")
        }
    }
}

private class SeedArgument(
    @get:Internal val fresh: Provider<FreshSeed>,
) : CommandLineArgumentProvider {
    override fun asArguments(): Iterable<String> = listOf("-D$SEED=${fresh.get().seed}")
}
