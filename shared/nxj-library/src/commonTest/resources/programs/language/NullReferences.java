public class NullReferences {
    int field;
    int[] array;

    void call() {
    }

    static String fails(int kind) {
        NullReferences none = null;
        int[] numbers = null;
        Object[] objects = null;
        String text = null;
        try {
            switch (kind) {
                case 0:
                    none.field = 1;
                    break;
                case 1:
                    return "" + none.field;
                case 2:
                    none.call();
                    break;
                case 3:
                    numbers[0] = 1;
                    break;
                case 4:
                    return "" + numbers.length;
                case 5:
                    return "" + objects[0];
                case 6:
                    return "" + text.length();
                case 7:
                    synchronized (text) {
                        return "locked";
                    }
                case 8:
                    return "" + new NullReferences().array[0];
                case 9:
                    return "" + (text instanceof String) + (String) (Object) text;
                default:
                    return "" + text + none;
            }
            return "nothing";
        } catch (NullPointerException missing) {
            return "null";
        }
    }

    public static void main(String[] arguments) {
        for (int kind = 0; kind < 11; kind++) System.out.println(kind + " " + fails(kind)); // expect 0 null
        // expect 1 null
        // expect 2 null
        // expect 3 null
        // expect 4 null
        // expect 5 null
        // expect 6 null
        // expect 7 null
        // expect 8 null
        // expect 9 falsenull
        // expect 10 nullnull
    }
}
