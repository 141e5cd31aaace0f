public class StringMethods {
    public static void main(String[] arguments) {
        String text = "Hello, World";
        System.out.println(text.length() + " " + text.charAt(4) + " " + text.isEmpty()); // expect 12 o false
        System.out.println(text.indexOf('o') + " " + text.indexOf('o', 5) + " " + text.indexOf("World") + " " + text.indexOf("x")); // expect 4 8 7 -1
        System.out.println(text.lastIndexOf('o') + " " + text.lastIndexOf("l", 5) + " " + text.lastIndexOf("Hello")); // expect 8 3 0
        System.out.println(text.substring(7) + "," + text.substring(0, 5) + "," + text.substring(12) + ","); // expect World,Hello,,
        System.out.println(text.startsWith("Hell") + " " + text.startsWith("World", 7) + " " + text.startsWith("ld", text.length() - 2)); // expect true true true
        System.out.println(text.toUpperCase() + text.toLowerCase()); // expect HELLO, WORLDhello, world
        System.out.println(text.replace('l', 'L')); // expect HeLLo, WorLd
        System.out.println("[" + "  a b ".trim() + "]"); // expect [a b]
        System.out.println("".concat("Hello")); // expect Hello
        System.out.println(("apple".compareTo("apricot") < 0) + " " + "a".compareTo("a") + " " + "b".compareTo("a")); // expect true 0 1
        System.out.println("ABC".equalsIgnoreCase("abc") + " " + "ABC".equals("abc")); // expect true false
        System.out.println(text.hashCode() + " " + "".hashCode()); // expect -505841268 0
        System.out.println(String.valueOf(3) + String.valueOf(2.5) + String.valueOf(true) + String.valueOf('c') + String.valueOf(7L)); // expect 32.5truec7
        System.out.println(new String(new char[] {'a', 'b', 'c'}, 1, 2)); // expect bc
        System.out.println(new String("bytes".getBytes()).equals("bytes")); // expect true
        System.out.println(text.subSequence(2, 4)); // expect ll
        System.out.println("a".equals(null)); // expect false
        try {
            System.out.println(text.charAt(12));
        } catch (IndexOutOfBoundsException wrong) {
            System.out.println("outside"); // expect outside
        }
        try {
            System.out.println(text.substring(5, 3));
        } catch (IndexOutOfBoundsException wrong) {
            System.out.println("backward"); // expect backward
        }
    }
}
