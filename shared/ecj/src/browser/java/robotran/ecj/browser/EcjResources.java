package robotran.ecj.browser;

import java.util.ArrayList;
import java.util.List;
import org.teavm.classlib.ResourceSupplier;
import org.teavm.classlib.ResourceSupplierContext;

/** Tells TeaVM which ECJ resources to keep in the WebAssembly module: parser tables, character tables and messages. */
public final class EcjResources implements ResourceSupplier {
    private static final String COMPILER = "org/eclipse/jdt/internal/compiler/";
    private static final int PARSER_TABLES = 24;
    private static final String[] LETTERS = {"start0", "start1", "start2", "part0", "part1", "part2", "part14"};

    @Override
    public String[] supplyResources(ResourceSupplierContext context) {
        List<String> files = new ArrayList<>();
        for (int table = 1; table <= PARSER_TABLES; table++) {
            files.add(COMPILER + "parser/parser" + table + ".rsc");
        }
        files.add(COMPILER + "parser/readableNames.props");
        for (String letters : LETTERS) {
            files.add(COMPILER + "parser/unicode/" + letters + ".rsc");
        }
        files.add(COMPILER + "problem/messages.properties");
        return files.toArray(new String[0]);
    }
}
