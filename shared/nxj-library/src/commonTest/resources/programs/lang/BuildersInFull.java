public class BuildersInFull {
    public static void main(String[] arguments) {
        StringBuilder text = new StringBuilder("robot");
        text.deleteCharAt(0).deleteCharAt(text.length() - 1);
        System.out.println(text + " " + text.length()); // expect obo 3
        text.append(new StringBuffer("t")).appendCodePoint(33);
        System.out.println(text); // expect obot!
        text.trimToSize();
        System.out.println(text.capacity()); // expect 5
        try {
            text.deleteCharAt(5);
        } catch (StringIndexOutOfBoundsException wrong) {
            System.out.println("no such place"); // expect no such place
        }
        StringBuffer buffer = new StringBuffer();
        buffer.append("abcdef").setLength(3);
        buffer.deleteCharAt(1).append(new StringBuffer("x")).appendCodePoint('y');
        System.out.println(buffer); // expect acxy
        buffer.trimToSize();
        System.out.println(buffer.capacity()); // expect 4
        String pair = "a" + new String(Character.toChars(0x1F916)) + "b";
        System.out.println(pair.length() + " " + pair.codePointCount(0, pair.length()) + " " + pair.codePointBefore(3)); // expect 4 3 129302
        System.out.println(pair.offsetByCodePoints(0, 2) + " " + pair.offsetByCodePoints(4, -2)); // expect 3 1
        System.out.println(Character.codePointAt(pair, 1) + " " + Character.codePointAt(pair.toCharArray(), 1, 2)); // expect 129302 55358
        System.out.println(Character.codePointBefore(pair, 1) + " " + Character.codePointBefore(pair.toCharArray(), 3, 2)); // expect 97 56598
        byte[] bytes = new byte[3];
        "robot".getBytes(1, 3, bytes, 1);
        System.out.println(bytes[0] + " " + bytes[1] + " " + bytes[2] + " " + new String(bytes, 0, 1, 2)); // expect 0 111 98 ob
        System.out.println("banana".lastIndexOf('n') + " " + "banana".lastIndexOf('n', 3) + " " + "banana".lastIndexOf('x')); // expect 4 2 -1
    }
}
