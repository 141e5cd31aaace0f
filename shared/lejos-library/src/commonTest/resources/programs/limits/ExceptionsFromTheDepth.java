public class ExceptionsFromTheDepth {
    public static void main(String[] arguments) {
        IllegalStateException same = new IllegalStateException();
        while (true) {
            try {
                again(same, 200);
            } catch (Throwable caught) {
                continue;
            }
        }
    }

    static void again(IllegalStateException same, int depth) {
        if (depth == 0) throw same;
        again(same, depth - 1);
    }
}
// runs on after 500
