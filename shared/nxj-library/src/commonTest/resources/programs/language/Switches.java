/** Branches to many cases. */
public class Switches {
    enum Colour { RED, GREEN, BLUE; Colour next() { return values()[(ordinal() + 1) % values().length]; } }

    public static void main(String[] args) {
        for (int i = -1; i < 5; i++) System.out.print(dense(i) + " ");
        System.out.println(); // expect none zero one and more  four none 
        System.out.println(sparse(-1000000) + sparse(7) + sparse(Integer.MAX_VALUE) + sparse(8)); // expect abc?
        System.out.println(letters("banana")); // expect 312
        for (Colour colour : Colour.values()) System.out.print(name(colour));
        System.out.println(); // expect rgb
        System.out.println(Colour.GREEN.next() + " " + Colour.BLUE.next()); // expect BLUE RED
        System.out.println(nested(2, (char) 120) + " " + nested(2, (char) 121) + " " + nested(3, (char) 120)); // expect 1002 1000 4
    }

    static String dense(int i) {
        switch (i) {
            case 0:
                return "zero";
            case 1:
                String more = "one";
                more += " and more";
                return more;
            case 2:
            case 3:
                break;
            default:
                return "none";
        }
        if (i == 2) return "";
        return "four";
    }

    static String sparse(int i) {
        String found = "?";
        switch (i) {
            case Integer.MAX_VALUE: found = "c"; break;
            case -1000000: found = "a"; break;
            case 7: found = "b"; break;
        }
        return found;
    }

    static String letters(String text) {
        int a = 0, b = 0, other = 0;
        for (int i = 0; i < text.length(); i++) {
            switch (text.charAt(i)) {
                case 'a': a++; continue;
                case 'b': b++; continue;
                default: other++;
            }
        }
        return "" + a + b + other;
    }

    static char name(Colour colour) {
        switch (colour) {
            case RED: return 'r';
            case GREEN: return 'g';
            default: return 'b';
        }
    }

    static int nested(int a, char b) {
        int sum = 0;
        switch (a) {
            case 2:
                switch (b) {
                    case 'x': sum += 1000;
                    case 'z': break;
                    default: sum += 1000;
                }
                sum += 2;
                return b == 'x' ? sum : 1000;
            case 3:
                return 1004 - 1000 + 1000 - 1000;
        }
        return 0;
    }
}
