package robotran.java

import org.eclipse.jdt.core.compiler.IProblem
import kotlin.test.Test
import kotlin.test.assertEquals

class ProblemNumberTest {
    @Test
    fun `the numbers are those of ECJ`() {
        val pairs = listOf(
            ProblemNumber.UNDEFINED_TYPE to IProblem.UndefinedType,
            ProblemNumber.TYPE_MISMATCH to IProblem.TypeMismatch,
            ProblemNumber.UNDEFINED_NAME to IProblem.UndefinedName,
            ProblemNumber.UNINITIALIZED_LOCAL_VARIABLE to IProblem.UninitializedLocalVariable,
            ProblemNumber.REDEFINED_LOCAL to IProblem.RedefinedLocal,
            ProblemNumber.REDEFINED_ARGUMENT to IProblem.RedefinedArgument,
            ProblemNumber.UNDEFINED_FIELD to IProblem.UndefinedField,
            ProblemNumber.NON_STATIC_FIELD to IProblem.NonStaticFieldFromStaticInvocation,
            ProblemNumber.UNRESOLVED_VARIABLE to IProblem.UnresolvedVariable,
            ProblemNumber.UNDEFINED_METHOD to IProblem.UndefinedMethod,
            ProblemNumber.METHOD_NOT_VISIBLE to IProblem.NotVisibleMethod,
            ProblemNumber.VOID_METHOD_RETURNS_VALUE to IProblem.VoidMethodReturnsValue,
            ProblemNumber.SHOULD_RETURN_VALUE to IProblem.ShouldReturnValue,
            ProblemNumber.PARAMETER_MISMATCH to IProblem.ParameterMismatch,
            ProblemNumber.NUMERIC_VALUE_OUT_OF_RANGE to IProblem.NumericValueOutOfRange,
            ProblemNumber.INVALID_OPERATOR to IProblem.InvalidOperator,
            ProblemNumber.CODE_CANNOT_BE_REACHED to IProblem.CodeCannotBeReached,
            ProblemNumber.UNHANDLED_EXCEPTION to IProblem.UnhandledException,
            ProblemNumber.ASSIGNMENT_HAS_NO_EFFECT to IProblem.AssignmentHasNoEffect,
            ProblemNumber.POSSIBLE_ACCIDENTAL_BOOLEAN_ASSIGNMENT to IProblem.PossibleAccidentalBooleanAssignment,
            ProblemNumber.EMPTY_STATEMENT to IProblem.EmptyControlFlowStatement,
            ProblemNumber.NON_STATIC_METHOD to IProblem.StaticMethodRequested,
            ProblemNumber.PARSING_ERROR to IProblem.ParsingError,
            ProblemNumber.UNMATCHED_BRACKET to IProblem.UnmatchedBracket,
            ProblemNumber.PARSING_ERROR_INSERT_BEFORE to IProblem.ParsingErrorInsertTokenBefore,
            ProblemNumber.PARSING_ERROR_INSERT_AFTER to IProblem.ParsingErrorInsertTokenAfter,
            ProblemNumber.PARSING_ERROR_DELETE to IProblem.ParsingErrorDeleteToken,
            ProblemNumber.PARSING_ERROR_INSERT_TO_COMPLETE to IProblem.ParsingErrorInsertToComplete,
            ProblemNumber.INVALID_CHARACTER_CONSTANT to IProblem.InvalidCharacterConstant,
            ProblemNumber.UNTERMINATED_STRING to IProblem.UnterminatedString,
            ProblemNumber.PUBLIC_CLASS_MUST_MATCH_FILE_NAME to IProblem.PublicClassMustMatchFileName,
            ProblemNumber.IMPORT_NOT_FOUND to IProblem.ImportNotFound,
            ProblemNumber.TYPE_PARAMETERS to IProblem.InvalidUsageOfTypeParameters,
            ProblemNumber.STATIC_IMPORT to IProblem.InvalidUsageOfStaticImports,
            ProblemNumber.FOR_EACH to IProblem.InvalidUsageOfForeachStatements,
            ProblemNumber.TYPE_ARGUMENTS to IProblem.InvalidUsageOfTypeArguments,
            ProblemNumber.ENUM to IProblem.InvalidUsageOfEnumDeclarations,
            ProblemNumber.VARARGS to IProblem.InvalidUsageOfVarargs,
            ProblemNumber.ANNOTATION to IProblem.InvalidUsageOfAnnotations,
            ProblemNumber.LAMBDA to IProblem.LambdaExpressionNotBelow18,
            ProblemNumber.METHOD_REFERENCE to IProblem.MethodReferenceNotBelow18,
        )
        pairs.forEach { (ours, theirs) -> assertEquals(theirs and IProblem.IgnoreCategoriesMask, ours) }
    }
}
