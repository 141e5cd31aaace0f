package robotran.lejoslibrary

import org.apache.bcel.Const
import org.apache.bcel.classfile.ClassParser
import org.apache.bcel.classfile.ConstantCP
import org.apache.bcel.classfile.ConstantClass
import org.apache.bcel.classfile.ConstantNameAndType
import org.apache.bcel.classfile.JavaClass

/** What of the library [programs], class files by name, call or implement. */
internal class LibraryUse(programs: Map<String, ByteArray>) {
    private val ownClasses = programs.map { (name, bytes) -> ClassParser(bytes.inputStream(), name).parse() }
    private val classes = (ownClasses + libraryClassFiles).associateBy { it.className }

    /** Each method and constructor as `josx.robotics.Arbitrator.start()V`. */
    val members: Set<String> = (
        ownClasses.flatMap(::calls) + ownClasses.flatMap(::implemented) +
            ownClasses.flatMap(::runs)
    ).toSet()

    private fun calls(caller: JavaClass): List<String> {
        val constants = caller.constantPool
        return constants.constantPool.filterIsInstance<ConstantCP>().filter { it.tag in METHOD_TAGS }.map { constant ->
            val owner = constants.getConstant<ConstantClass>(constant.classIndex).getBytes(constants).replace('/', '.')
            val member = constants.getConstant<ConstantNameAndType>(constant.nameAndTypeIndex)
            declarationsOf(owner, member.getName(constants) + member.getSignature(constants))
        }.flatten()
    }

    /** The method that a call of [called] reaches, and those it has to be there for. */
    private fun declarationsOf(owner: String, called: String): List<String> {
        val declaring = typesOf(owner).filter { declares(it, called) }
        val demanding = declaring.drop(1).filter { isAbstract(it, called) }
        return (declaring.take(1) + demanding).map { "${it.className}.$called" }
    }

    /** What a program has to write is used by writing it. */
    private fun implemented(programClass: JavaClass): List<String> {
        val own = programClass.methods.map { it.name + it.signature }
        return typesOf(programClass.className).drop(1).flatMap { type ->
            own.filter { isAbstract(type, it) }.map { "${type.className}.$it" }
        }
    }

    /** The brick itself calls `run` of a thread: of the program's class or of one that it names. */
    private fun runs(programClass: JavaClass): List<String> {
        val constants = programClass.constantPool
        val named = constants.constantPool.filterIsInstance<ConstantClass>()
            .map { it.getBytes(constants).replace('/', '.') }
        val threads = (named + programClass.className).filter { name -> typesOf(name).any { it.className == THREAD } }
        return threads.flatMap { declarationsOf(it, RUN) }
    }

    /** The class [name], all that it extends, and all that these implement. */
    private fun typesOf(name: String): List<JavaClass> {
        val declared = classes[name] ?: return emptyList()
        val above = if (declared.isInterface || name == OBJECT) emptyList() else typesOf(declared.superclassName)
        return listOf(declared) + above + declared.interfaceNames.flatMap(::typesOf)
    }

    private fun isAbstract(type: JavaClass, member: String): Boolean =
        type.methods.any { it.isAbstract && it.name + it.signature == member }

    private fun declares(type: JavaClass, member: String): Boolean = type.methods.any {
        it.name + it.signature == member
    }

    private companion object {
        const val OBJECT = "java.lang.Object"
        const val THREAD = "java.lang.Thread"
        const val RUN = "run()V"
        val METHOD_TAGS = setOf(Const.CONSTANT_Methodref, Const.CONSTANT_InterfaceMethodref)
    }
}
