package robotran.nxjlibrary

import org.eclipse.jdt.internal.compiler.CompilationResult
import org.eclipse.jdt.internal.compiler.DefaultErrorHandlingPolicies
import org.eclipse.jdt.internal.compiler.ast.AbstractMethodDeclaration
import org.eclipse.jdt.internal.compiler.ast.AbstractVariableDeclaration
import org.eclipse.jdt.internal.compiler.ast.FieldDeclaration
import org.eclipse.jdt.internal.compiler.ast.Javadoc
import org.eclipse.jdt.internal.compiler.ast.TypeDeclaration
import org.eclipse.jdt.internal.compiler.batch.CompilationUnit
import org.eclipse.jdt.internal.compiler.classfmt.ClassFileConstants
import org.eclipse.jdt.internal.compiler.impl.CompilerOptions
import org.eclipse.jdt.internal.compiler.parser.Parser
import org.eclipse.jdt.internal.compiler.problem.DefaultProblemFactory
import org.eclipse.jdt.internal.compiler.problem.ProblemReporter

/** A public class of the library as its source tells of it, in the order of the source. */
internal class JavaHelp(private val source: String) {
    private val type: TypeDeclaration

    init {
        val options = CompilerOptions().apply {
            sourceLevel = ClassFileConstants.JDK1_5
            docCommentSupport = true
        }
        val reporter =
            ProblemReporter(DefaultErrorHandlingPolicies.proceedWithAllProblems(), options, DefaultProblemFactory())
        val unit = CompilationUnit(source.toCharArray(), "Help.java", "UTF-8")
        type = Parser(reporter, true).parse(unit, CompilationResult(unit, 0, 1, 1)).types.first()
    }

    private val isEnum = TypeDeclaration.kind(type.modifiers) == TypeDeclaration.ENUM_DECL
    private val isInterface = TypeDeclaration.kind(type.modifiers) == TypeDeclaration.INTERFACE_DECL
    private val visibleMethods: List<AbstractMethodDeclaration> =
        type.methods.orEmpty().filter {
            !it.isClinit && !it.isDefaultConstructor && (isInterface || it.modifiers and VISIBLE != 0)
        }
    private val visibleFields = type.fields.orEmpty().filter { it.isField(isInterface) }

    /** Whether programs use it; annotations tell about themselves. */
    val isPublic: Boolean
        get() = type.modifiers and ClassFileConstants.AccPublic != 0 &&
            TypeDeclaration.kind(type.modifiers) != TypeDeclaration.ANNOTATION_TYPE_DECL

    /** The first sentence about the class; empty if it says nothing. */
    val ofClass: String get() = firstSentence(type.javadoc)

    /** The first sentence about each method, constructor and field that programs can use; empty if it says nothing. */
    val ofMembers: List<Pair<String, String>>
        get() = visibleFields.map { String(it.name) to firstSentence(it.javadoc) } +
            visibleMethods.map { written(it) to firstSentence(it.javadoc) }

    private val className = String(type.name)

    private fun written(method: AbstractMethodDeclaration): String {
        val before = when {
            method.isConstructor -> "new "
            method.isStatic -> "$className."
            else -> ""
        }
        return before + String(method.selector) +
            method.arguments.orEmpty().joinToString(", ", "(", ")") { it.type.toString() }
    }

    /** Constants of an enum have no modifiers, and initialisers are fields without a type. */
    private fun FieldDeclaration.isField(isInterface: Boolean) = when {
        isEnum && getKind() == AbstractVariableDeclaration.ENUM_CONSTANT -> true
        this.type == null -> false
        else -> isInterface || modifiers and VISIBLE != 0
    }

    private fun firstSentence(comment: Javadoc?): String {
        if (comment == null) return ""
        val text = source.substring(comment.sourceStart, comment.sourceEnd + 1).removePrefix("/**").removeSuffix("*/")
        val plain = text.lines().joinToString(" ") { it.trim().removePrefix("*").trim() }.trim()
        return SENTENCE.find(plain)?.value.orEmpty()
    }

    private companion object {
        const val VISIBLE = ClassFileConstants.AccPublic or ClassFileConstants.AccProtected
        val SENTENCE = Regex("""^[A-Z][^<@]*?[.](?=\s|$)""")
    }
}
