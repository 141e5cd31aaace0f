package robotran.ecj;

import java.io.OutputStream;
import java.io.PrintWriter;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.jdt.internal.compiler.CompilationResult;
import org.eclipse.jdt.internal.compiler.Compiler;
import org.eclipse.jdt.internal.compiler.DefaultErrorHandlingPolicies;
import org.eclipse.jdt.internal.compiler.ICompilerRequestor;
import org.eclipse.jdt.internal.compiler.ast.CompilationUnitDeclaration;
import org.eclipse.jdt.internal.compiler.env.INameEnvironment;
import org.eclipse.jdt.internal.compiler.impl.CompilerOptions;

/**
 * ECJ that also checks each source with resolved types, and prints nothing when it fails. It checks what is special about the
 * brick, and if there are gaps {@link LibraryGaps}, for an RCX also {@link LargeSteps}.
 */
final class CheckingCompiler extends Compiler {
    private final BrickTarget target;
    private final Set<String> gaps;
    private final List<EcjProblem> problems;
    private final Map<String, MemberNames> memberNames = new HashMap<>();
    private boolean crashed;

    /** @param gaps see {@link EcjCompiler#addGap} */
    CheckingCompiler(
            INameEnvironment library,
            CompilerOptions options,
            BrickTarget target,
            ICompilerRequestor results,
            Set<String> gaps,
            List<EcjProblem> problems) {
        super(
            library, DefaultErrorHandlingPolicies.proceedWithAllProblems(), options, results, new EcjMessages(), silence(),
            null);
        this.target = target;
        this.gaps = gaps;
        this.problems = problems;
        useSingleThread = true;
    }

    boolean crashed() {
        return crashed;
    }

    /** What the classes have whose members the source {@code path} names wrongly. */
    MemberNames memberNames(String path) {
        return memberNames.getOrDefault(path, new MemberNames());
    }

    @Override
    public void process(CompilationUnitDeclaration unit, int place) {
        super.process(unit, place);
        String path = new String(unit.getFileName());
        if (unit.compilationResult.hasErrors()) {
            memberNames.put(path, memberNamesOf(unit));
        }
        if (unit.compilationResult.hasSyntaxError) {
            return; // After a syntax error, the tree contains guesses.
        }
        BrickReport report = new BrickReport(path);
        if (target.hasRules()) {
            unit.traverse(new BrickRules(report), unit.scope);
            unit.traverse(new LockRules(report), unit.scope);
        }
        if (target.copiesTexts()) {
            unit.traverse(new TextComparisons(report), unit.scope);
        }
        if (!gaps.isEmpty()) {
            unit.traverse(new LibraryGaps(gaps, report), unit.scope);
            if (target.hasRules()) {
                unit.traverse(new LargeSteps(report), unit.scope);
            }
        }
        problems.addAll(report.problems());
    }

    private static MemberNames memberNamesOf(CompilationUnitDeclaration unit) {
        MemberNames names = new MemberNames();
        try {
            names.visit(unit);
        } catch (RuntimeException incompleteTree) {
            // Its mistakes are told with fewer names.
        }
        return names;
    }

    @Override
    protected void handleInternalException(
            Throwable failure, CompilationUnitDeclaration unit, CompilationResult result) {
        crashed = true;
        if (unit != null && unit.compilationResult.hasErrors()) {
            // A program with many mistakes can be too much work; it is better to tell them.
            requestor.acceptResult(unit.compilationResult);
        }
    }

    private static PrintWriter silence() {
        return new PrintWriter(new OutputStream() {
            @Override
            public void write(int octet) {}
        });
    }
}
