package robotran.tinyvm.link

import robotran.tinyvm.classfile.CodeEntry
import robotran.tinyvm.config.BrickLayout
import robotran.tinyvm.config.BrickRoom
import robotran.tinyvm.config.MachineModel
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.messages.UnsupportedFeature

/**
 * Links a program: its main class and every class it needs, from the program and the library.
 *
 * @param model the machine that the program is for.
 * @param room the memory of the RCX that the program must fit; null for another brick.
 * @param layout what it is there; null for an estimate of its size.
 * @param hasNative whether the machine implements this native method.
 */
internal class Linker(
    private val files: ClassPath,
    private val messages: TinyVmMessages,
    private val model: MachineModel,
    private val room: BrickRoom?,
    private val layout: BrickLayout?,
    private val hasNative: (LinkedMethod) -> Boolean,
) {
    private val types = TypeTable(files, messages, model)
    private val reachable = ReachableMethods(types)
    private val texts = StringPool()
    private val budget = VerifierBudget(TinyVmLimits.VERIFIED_WORDS)

    /** @param mainClass the internal name of the main class; null for the first class with a main method. */
    fun link(mainClass: String?): LinkedProgram {
        val start = CodeLocation(mainClass ?: files.ownNames.firstOrNull().orEmpty())
        val main = findMain(mainClass) ?: start.reject(messages.noMainMethod())
        val exceptions = BuiltInException.of(model).map { types.classNamed(it.className, start) }
        if (exceptions.any { !it.isA(types.throwable) }) start.unsound(messages)
        val text = types.text
        val textField = text.instanceFields.firstOrNull()?.takeIf { it.descriptor == "[C" } ?: start.unsound(messages)
        val thread = types.classNamed("java/lang/Thread", start)
        val run = thread.findMethod("run", "()V")?.takeIf { it.virtualIndex >= 0 } ?: start.unsound(messages)
        val characters = types.typeOf("[C", start) as ArrayType
        val classType = if (model.isExact) types.classNamed("java/lang/Class", start) else null
        val wholeNumbers = if (model.isExact) types.typeOf("[I", start) as ArrayType else null
        val bytes8 = if (model.isExact) types.typeOf("[B", start) as ArrayType else null
        val texts1 = if (model.isExact) types.typeOf("[Ljava/lang/String;", start) as ArrayType else null
        val uncaughtHandler = if (model.isExact) thread.methods.find { it.signature == UNCAUGHT_HANDLER } else null
        if (model.isExact) {
            linkReachable(main, run, uncaughtHandler, exceptions + listOfNotNull(types.root, text, thread, classType))
        } else {
            linkBodies()
        }
        types.members.completeInterfaces(types.classes)
        val bytes = if (room == null) 0 else bytesIn(room, listOf(main, run), start)
        return LinkedProgram(
            main,
            types.types,
            types.classes,
            types.members.methods,
            types.members.statics,
            types.members.staticWords,
            texts.texts,
            bytes,
            exceptions,
            text,
            textField,
            characters,
            thread,
            run,
            types.throwable,
            layout,
            wholeNumbers,
            bytes8,
            texts1,
            classType,
            uncaughtHandler,
        )
    }

    private fun bytesIn(room: BrickRoom, first: List<LinkedMethod>, start: CodeLocation): Int {
        val bytes = layout?.imageBytes ?: ProgramSize(types.classes, texts.texts).bytes(first)
        if (bytes > room.maxImageBytes) start.reject(messages.programTooLarge(bytes, room.maxImageBytes))
        return bytes
    }

    private fun findMain(mainClass: String?): LinkedMethod? {
        val names = if (mainClass == null) files.ownNames.toList() else listOf(mainClass).filter { files.isOwn(it) }
        val name = names.firstOrNull { name ->
            files.find(name)?.methods?.any { it.name == MAIN && it.descriptor == MAIN_DESCRIPTOR } == true
        } ?: return null
        return types.classNamed(name, CodeLocation(name)).methods.find {
            it.name == MAIN && it.descriptor == MAIN_DESCRIPTOR && it.isStatic
        }
    }

    /** Linking a body may link more classes, which append their methods. */
    private fun linkBodies() {
        var next = 0
        while (next < types.members.methods.size) linkBody(types.members.methods[next++])
    }

    /** Links what [main] and the machine itself call; the machine makes objects of the classes [made]. */
    private fun linkReachable(
        main: LinkedMethod,
        run: LinkedMethod,
        uncaughtHandler: LinkedMethod?,
        made: List<LinkedClass>,
    ) {
        reachable.call(main)
        reachable.initialize(main.owner)
        reachable.callOverridable(run)
        uncaughtHandler?.let { reachable.call(it) }
        made.forEach { reachable.make(it) }
        while (true) linkBody(reachable.next() ?: break)
        for (field in types.members.statics) {
            val value = field.initialValue
            if (field.isRead && value is InitialValue.Text) texts.numberOf(value.text)
        }
    }

    private fun linkBody(method: LinkedMethod) {
        val location = CodeLocation(method.owner.name, method.name)
        val entry = method.entry.code
        when {
            method.isNative -> if (!hasNative(method)) location.reject(messages.nativeMethod(method.name))

            entry != null -> {
                checkSizes(method, entry, location)
                val code = Verifier(method, entry, types, messages, budget).verify()
                if (model.isExact) reachable.follow(code) else method.called = code.methods.values.toSet()
                method.body = Translator(method, entry, code, types, texts).translate()
            }
        }
    }

    private fun checkSizes(method: LinkedMethod, entry: CodeEntry, location: CodeLocation) {
        fun check(count: Int, limit: Int, counted: Counted) {
            if (count > limit) location.reject(messages.tooMany(counted, limit))
        }
        check(entry.maxLocals, TinyVmLimits.LOCALS, Counted.LOCALS)
        check(entry.maxStack, TinyVmLimits.OPERANDS, Counted.OPERANDS)
        check(entry.handlers.size, TinyVmLimits.EXCEPTION_HANDLERS, Counted.HANDLERS)
        check(entry.bytes.size, TinyVmLimits.CODE_BYTES, Counted.CODE_BYTES)
        if (method.owner.isInterface && !method.isStatic) {
            location.reject(messages.unsupportedFeature(UnsupportedFeature.INTERFACE_CODE))
        }
        if (entry.maxLocals < method.argumentWords) location.unsound(messages)
    }

    private companion object {
        const val MAIN = "main"
        const val UNCAUGHT_HANDLER = "systemUncaughtExceptionHandler(Ljava/lang/Throwable;II)V"
        const val MAIN_DESCRIPTOR = "([Ljava/lang/String;)V"
    }
}
