package robotran.ecj;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.eclipse.jdt.internal.compiler.ast.ASTNode;

/** The problems that {@link BrickRules} finds in one source. */
final class BrickReport {
    private final String path;
    private final List<EcjProblem> problems = new ArrayList<>();

    BrickReport(String path) {
        this.path = path;
    }

    List<EcjProblem> problems() {
        return problems;
    }

    void refuse(int number, ASTNode node) {
        add(number, true, node.sourceStart, node.sourceEnd + 1);
    }

    void refuse(int number, int start, int end, String... arguments) {
        add(number, true, start, end, arguments);
    }

    void warn(int number, int start, int end, String... arguments) {
        add(number, false, start, end, arguments);
    }

    void warn(int number, ASTNode node, int... arguments) {
        String[] texts = new String[arguments.length];
        for (int i = 0; i < arguments.length; i++) {
            texts[i] = Integer.toString(arguments[i]);
        }
        add(number, false, node.sourceStart, node.sourceEnd + 1, texts);
    }

    private void add(int number, boolean error, int start, int end, String... arguments) {
        problems.add(new EcjProblem(
            path, number, error, false, start, end, "", Arrays.asList(arguments), Collections.emptyList()));
    }
}
