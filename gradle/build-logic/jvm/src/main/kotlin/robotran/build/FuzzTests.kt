package robotran.build

import org.gradle.api.Project
import org.gradle.api.tasks.testing.Test
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/**
 * The tests of a module whose class names end with `FuzzTest`, which try arbitrary inputs. In `jvmTest`, and so in
 * `check`, they replay the inputs that once found a fault, and a few per cent of the others with the seed of
 * [PropertyTests]. `fuzzTest`, in `checkAll`, tries all of them, with a new seed in each build.
 */
object FuzzTests {
    const val TASK = "fuzzTest"
    private const val CLASSES = "*FuzzTest"
    private const val FILES = "src/jvmTest/**/*FuzzTest.kt"

    /** What these tests share, see `Fuzzing.kt` there. */
    private const val KIT = "shared/language/src/fuzzTest/kotlin"

    fun register(project: Project) {
        if (project.fileTree(project.projectDir) { it.include(FILES) }.isEmpty) return
        val kotlin = project.extensions.getByType(KotlinMultiplatformExtension::class.java)
        kotlin.sourceSets.getByName("jvmTest").kotlin.srcDir(project.rootProject.file(KIT))
        val all = TestParts.register(project, "jvmTest", TASK, CLASSES)
        all.configure { task ->
            task.description = "Tries tens of thousands of arbitrary inputs, on the JVM."
            task.systemProperty("robotran.fuzz.percent", "100")
        }
        project.tasks.withType(Test::class.java).configureEach {
            it.systemProperty("robotran.fuzz.task", "${project.path}:$TASK")
        }
        Rings.addToAll(project, all)
    }
}
