public class StringBuilders {
    public static void main(String[] arguments) {
        StringBuilder builder = new StringBuilder("abc");
        builder.append(1).append('d').append(2.5).append(true).append(3L).append((Object) null).append(1.5f);
        System.out.println(builder); // expect abc1d2.5true3null1.5
        System.out.println(builder.length() + " " + builder.charAt(3) + " " + builder.indexOf("true")); // expect 20 1 8
        builder.setCharAt(0, 'A');
        builder.delete(1, 3);
        System.out.println(builder); // expect A1d2.5true3null1.5
        builder.setLength(4);
        System.out.println(builder + "|"); // expect A1d2|
        builder.delete(0, 1);
        System.out.println(builder); // expect 1d2
        System.out.println(builder.substring(1) + builder.substring(0, 1)); // expect d21
        StringBuffer buffer = new StringBuffer();
        for (int i = 0; i < 50; i++) buffer.append(i % 10);
        System.out.println(buffer.length()); // expect 50
        System.out.println(buffer.toString().substring(40)); // expect 0123456789
        char[] letters = {'x', 'y'};
        System.out.println(new StringBuilder().append(letters).append("z")); // expect xyz
    }
}
