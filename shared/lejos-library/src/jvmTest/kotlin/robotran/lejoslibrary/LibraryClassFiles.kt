package robotran.lejoslibrary

import org.apache.bcel.classfile.ClassParser
import org.apache.bcel.classfile.JavaClass

internal val libraryClassFiles: List<JavaClass> = LejosLibrary.classNames.map { name ->
    ClassParser(checkNotNull(LejosLibrary.classFile(name)).inputStream(), name).parse()
}
