package robotran.nxjlibrary

import kotlinx.coroutines.test.runTest
import org.apache.bcel.classfile.ClassParser
import org.apache.bcel.classfile.JavaClass

internal val library: NxjLibrary by lazy { loaded { NxjLibrary.load() } }

internal val sources: NxjSources by lazy { loaded { NxjSources.load() } }

internal val libraryClasses: List<JavaClass> by lazy { library.classFiles.map { (name, file) -> parsed(name, file) } }

internal fun parsed(name: String, file: ByteArray): JavaClass = ClassParser(file.inputStream(), name).parse()

private fun <T> loaded(load: suspend () -> T): T {
    var result: T? = null
    runTest { result = load() }
    return checkNotNull(result)
}
