package robotran.build.lejos

import org.gradle.api.DefaultTask
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.ConfigurableFileTree
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.workers.WorkerExecutor
import javax.inject.Inject

/**
 * Compiles Java for a brick with ECJ: a class library with its own `java.lang`, or programs that use one. The output is
 * reproducible. [textFolder] also receives each class file in Base64, as `NAME.class`, for generated Kotlin.
 */
@CacheableTask
abstract class CompileForBrick : DefaultTask() {
    /** ECJ, isolated from Gradle's classpath. */
    @get:Classpath
    abstract val compiler: ConfigurableFileCollection

    /** The class files of the library to compile against; empty when compiling the library itself. */
    @get:Classpath
    abstract val library: ConfigurableFileCollection

    @get:Internal
    abstract val sources: Property<ConfigurableFileTree>

    @get:InputFiles
    @get:PathSensitive(PathSensitivity.RELATIVE)
    val files get() = sources.get()

    @get:Input
    abstract val target: Property<BrickTarget>

    /**
     * Whether each source is a separate program, whose class files go into a folder named after the source, such as
     * `robots/Square.java`. Sources with a line `// error LINE` are left out then.
     */
    @get:Input
    abstract val eachAlone: Property<Boolean>

    @get:OutputDirectory
    abstract val classFolder: DirectoryProperty

    @get:OutputDirectory
    abstract val textFolder: DirectoryProperty

    @get:Inject
    abstract val workers: WorkerExecutor

    @TaskAction
    fun compile() {
        workers.classLoaderIsolation { it.classpath.from(compiler) }.submit(CompileForBrickAction::class.java) {
            it.sources.from(files)
            it.sourceFolder.set(files.dir)
            it.language.set(target.map { brick -> brick.language })
            it.classFiles.set(target.map { brick -> brick.classFiles })
            it.eachAlone.set(eachAlone)
            it.library.from(library)
            it.noClasses.set(temporaryDir)
            it.classFolder.set(classFolder)
            it.textFolder.set(textFolder)
        }
    }
}
