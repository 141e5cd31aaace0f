package robotran.tinyvm.run

import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.QuirkHandling
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.link.Operation

/** Object and array operations that are too rare for the interpreter's loop. */
internal class ObjectOperations(
    private val machine: VirtualMachine,
    private val calls: Calls,
    private val places: ArrayAddressing,
) {
    private val words = machine.heap.words
    private val types = machine.program.types.toTypedArray()
    private val tests = TypeTests(machine)
    private val isExact = machine.model.isExact
    private val wrongElement = if (isExact) BuiltInException.ARRAY_STORE else BuiltInException.CLASS_CAST

    /** Executes [operation] for [thread]; its operands start at `next` of [frame]. */
    fun execute(thread: VmThread, frame: Frame, operation: Int) {
        val code = frame.body.code
        val stack = thread.stack
        when (operation) {
            Operation.PUSH_TEXT -> push(thread, frame, machine.text(code[frame.next++]))

            Operation.ELEMENT_WIDE -> {
                val place = places.find(stack[frame.top - 2], stack[frame.top - 1])
                if (place <= 0) {
                    calls.throwNew(thread, places.failure(place))
                } else {
                    stack[frame.top - 2] = words[place]
                    stack[frame.top - 1] = 0
                }
            }

            Operation.SET_WIDE -> {
                frame.top -= 4
                val place = places.find(stack[frame.top], stack[frame.top + 1])
                if (place <= 0) calls.throwNew(thread, places.failure(place)) else words[place] = stack[frame.top + 2]
            }

            Operation.SET_SHORT -> {
                frame.top -= 3
                val place = places.find(stack[frame.top], stack[frame.top + 1])
                if (place <= 0) {
                    calls.throwNew(thread, places.failure(place))
                } else {
                    words[place] = stack[frame.top + 2].toShort().toInt()
                }
            }

            Operation.SET_REFERENCE -> storeReference(thread, frame)

            Operation.FIELD_WIDE -> {
                val reference = stack[frame.top - 1]
                if (reference == 0) {
                    calls.throwNew(thread, BuiltInException.NULL_POINTER)
                } else {
                    stack[frame.top - 1] = words[reference + Heap.HEADER_WORDS + code[frame.next++]]
                    stack[frame.top++] = 0
                }
            }

            Operation.SET_FIELD_WIDE -> {
                frame.top -= 3
                val reference = stack[frame.top]
                if (reference == 0) {
                    calls.throwNew(thread, BuiltInException.NULL_POINTER)
                } else {
                    words[reference + Heap.HEADER_WORDS + code[frame.next++]] = stack[frame.top + 1]
                }
            }

            Operation.SET_FIELD_CHARACTER -> {
                frame.top -= 2
                val reference = stack[frame.top]
                if (reference == 0) {
                    calls.throwNew(thread, BuiltInException.NULL_POINTER)
                } else {
                    val field = reference + Heap.HEADER_WORDS + code[frame.next++]
                    words[field] = places.storedCharacter(stack[frame.top + 1])
                }
            }

            Operation.SET_STATIC_CHARACTER -> {
                machine.statics[code[frame.next++]] = places.storedCharacter(stack[--frame.top])
            }

            Operation.CALL_INTERFACE -> {
                val receiver = stack[frame.top - code[frame.next + 1]]
                val method = if (receiver == 0) null else types[words[receiver]].interfaceMethods[code[frame.next]]
                frame.next += 2
                when {
                    receiver == 0 -> calls.throwNew(thread, BuiltInException.NULL_POINTER)
                    method == null -> calls.throwNew(thread, BuiltInException.NO_SUCH_METHOD)
                    else -> calls.call(thread, frame, method, TWO_OPERANDS_AND_OPERATION, isVirtual = true)
                }
            }

            Operation.RETURN_WIDE -> calls.leave(thread, 2)
            Operation.NEW -> push(thread, frame, machine.newObject(types[code[frame.next++]] as LinkedClass))

            Operation.NEW_ARRAY -> {
                val length = stack[--frame.top]
                if (isExact && length < 0) return calls.throwNew(thread, BuiltInException.NEGATIVE_ARRAY_SIZE)
                pushArray(thread, frame, machine.newArray(types[code[frame.next++]] as ArrayType, length))
            }

            Operation.NEW_ARRAYS -> {
                val type = types[code[frame.next++]] as ArrayType
                val dimensions = code[frame.next++]
                frame.top -= dimensions
                if (isExact && (0 until dimensions).any { stack[frame.top + it] < 0 }) {
                    return calls.throwNew(thread, BuiltInException.NEGATIVE_ARRAY_SIZE)
                }
                pushArray(thread, frame, machine.newArrays(type, stack, frame.top, dimensions))
            }

            Operation.THROW -> {
                val exception = stack[--frame.top]
                if (exception == 0) {
                    calls.throwNew(thread, BuiltInException.NULL_POINTER)
                } else {
                    calls.throwObject(thread, exception)
                }
            }

            Operation.CAST -> {
                val reference = stack[frame.top - 1]
                if (reference != 0 && !tests.isInstance(reference, code[frame.next])) {
                    calls.throwNew(thread, BuiltInException.CLASS_CAST, HandlerEntry.LATE)
                } else {
                    frame.next++
                }
            }

            Operation.IS_INSTANCE -> {
                val reference = stack[frame.top - 1]
                stack[frame.top - 1] = if (reference != 0 && tests.isInstance(reference, code[frame.next])) 1 else 0
                frame.next++
            }

            Operation.ENTER_MONITOR -> {
                val lock = stack[frame.top - 1]
                when {
                    lock == 0 -> calls.throwNew(thread, BuiltInException.NULL_POINTER)
                    machine.monitors.enter(lock, thread) -> frame.top--

                    else -> {
                        frame.next--
                        calls.block(thread, lock)
                    }
                }
            }

            Operation.EXIT_MONITOR -> {
                val lock = stack[--frame.top]
                if (lock != 0 && !machine.monitors.exit(lock, thread)) {
                    calls.throwNew(thread, BuiltInException.ILLEGAL_MONITOR_STATE)
                }
            }

            else -> error("no operation $operation")
        }
    }

    private fun storeReference(thread: VmThread, frame: Frame) {
        val stack = thread.stack
        frame.top -= 3
        val array = stack[frame.top]
        val value = stack[frame.top + 2]
        val place = places.find(array, stack[frame.top + 1])
        when {
            place <= 0 -> calls.throwNew(thread, places.failure(place))
            value == 0 || tests.mayStore(array, value) -> words[place] = value
            else -> storeOther(thread, place)
        }
    }

    /**
     * Stores an object at [place] in an array of another class. A brick does so without a word, and then takes the object
     * for one of that class. Here the element becomes null, since what follows would make no sense.
     */
    private fun storeOther(thread: VmThread, place: Int) {
        machine.addWarning(Quirk.UNCHECKED_ELEMENT)
        if (machine.model.elements == QuirkHandling.APPLY) words[place] = 0 else calls.throwNew(thread, wrongElement)
    }

    private fun pushArray(thread: VmThread, frame: Frame, reference: Int) {
        if (reference == 0) {
            calls.throwNew(thread, BuiltInException.OUT_OF_MEMORY, HandlerEntry.WITHOUT_EXCEPTION)
        } else {
            push(thread, frame, reference)
        }
    }

    private fun push(thread: VmThread, frame: Frame, reference: Int) {
        if (reference == 0) {
            calls.throwNew(thread, BuiltInException.OUT_OF_MEMORY)
        } else {
            thread.stack[frame.top++] = reference
        }
    }

    private companion object {
        const val TWO_OPERANDS_AND_OPERATION = 3
    }
}
