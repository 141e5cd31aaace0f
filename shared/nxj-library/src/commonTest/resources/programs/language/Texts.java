public class Texts {
    static String none;
    static final String JOINED = "a" + 1 + 'b' + 2.5 + true + 3L;

    public static void main(String[] arguments) {
        System.out.println(JOINED); // expect a1b2.5true3
        System.out.println("none is " + none); // expect none is null
        String text = "x";
        text += 1;
        text += 'y';
        text += 2.0f;
        text += null;
        System.out.println(text); // expect x1y2.0null
        System.out.println(1 + 2 + "3" + 4 + 5); // expect 3345
        System.out.println('a' + 'b' + "c"); // expect 195c
        System.out.println("" + 'a' + 'b'); // expect ab
        char[] letters = {'h', 'i'};
        System.out.println(String.valueOf(letters) + letters.length); // expect hi2
        System.out.println("same" == "same"); // expect true
        System.out.println("same" == "sa" + "me"); // expect true
        String part = "sa";
        System.out.println("same" == part + "me"); // expect false
        System.out.println("same".equals(part + "me")); // expect true
        System.out.println("tab\tquote\"back\\slash".length()); // expect 20
        System.out.println("\u0041\101\60"); // expect AA0
        System.out.println("long line " + 1234567890123456789L + " and " + 1.0e-5 + " " + 1e10f); // expect long line 1234567890123456789 and 1.0E-5 1.0E10
        for (char letter : "abc".toCharArray()) System.out.println((char) (letter + 1)); // expect b
        // expect c
        // expect d
        StringBuilder built = new StringBuilder();
        for (int i = 0; i < 20; i++) built.append(i).append(i % 2 == 0 ? "," : ";");
        System.out.println(built); // expect 0,1;2,3;4,5;6,7;8,9;10,11;12,13;14,15;16,17;18,19;
        System.out.println(built.length()); // expect 50
    }
}
