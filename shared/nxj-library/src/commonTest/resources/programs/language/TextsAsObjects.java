// only here
/** A brick makes a new object each time a text of the program is used. */
public class TextsAsObjects {
    static final String MODE = "line";
    static final String KEPT = new String("line");

    static String mode() {
        return "line";
    }

    public static void main(String[] arguments) {
        String mode = "line";
        System.out.println(mode == "line"); // expect false
        System.out.println(mode == MODE); // expect false
        System.out.println(mode() == mode()); // expect false
        System.out.println(mode != "line"); // expect true
        System.out.println(KEPT == KEPT); // expect true
        System.out.println(mode.equals(MODE) && mode().equals("line")); // expect true
        String same = mode;
        System.out.println(same == mode); // expect true
        System.out.println("line" == "li" + "ne"); // expect true
        String last = null;
        int different = 0;
        for (int i = 0; i < 3; i++) {
            String text = "x";
            if (text != last) different++;
            last = text;
        }
        System.out.println(different); // expect 3
        int length = 0;
        for (int i = 0; i < 20000; i++) length += "filled".length();
        System.out.println(length); // expect 120000
    }
}
