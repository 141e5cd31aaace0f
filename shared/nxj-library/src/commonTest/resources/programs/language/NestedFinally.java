public class NestedFinally {
    static String log = "";

    static int run(int kind) {
        log = "";
        try {
            try {
                log += "a";
                if (kind == 1) return 1;
                if (kind == 2) throw new IllegalStateException("two");
                for (int i = 0; i < 3; i++) {
                    try {
                        if (kind == 3 && i == 1) break;
                        if (kind == 4) continue;
                        if (kind == 5) throw new IllegalArgumentException("five");
                        log += i;
                    } finally {
                        log += "f";
                    }
                }
                log += "b";
            } finally {
                log += "c";
                if (kind == 6) throw new ArithmeticException("six");
            }
        } catch (IllegalStateException wrong) {
            log += wrong.getMessage();
            return 2;
        } catch (RuntimeException wrong) {
            log += "r" + wrong.getMessage();
        } finally {
            log += "d";
            try {
                if (kind == 7) throw new Error("seven");
            } catch (Error wrong) {
                log += wrong.getMessage();
            } finally {
                log += "e";
            }
        }
        return 0;
    }

    public static void main(String[] arguments) {
        for (int kind = 0; kind < 8; kind++) {
            int result = run(kind);
            System.out.println(kind + " " + result + " " + log); // expect 0 0 a0f1f2fbcde
            // expect 1 1 acde
            // expect 2 2 actwode
            // expect 3 0 a0ffbcde
            // expect 4 0 afffbcde
            // expect 5 0 afcrfivede
            // expect 6 0 a0f1f2fbcrsixde
            // expect 7 0 a0f1f2fbcdsevene
        }
    }
}
