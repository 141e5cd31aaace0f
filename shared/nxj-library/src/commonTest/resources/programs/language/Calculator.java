public class Calculator {
    static class SyntaxProblem extends Exception {
        final int place;

        SyntaxProblem(String message, int place) {
            super(message + " at " + place);
            this.place = place;
        }
    }

    private final String text;
    private int place;

    Calculator(String text) {
        this.text = text;
    }

    double value() throws SyntaxProblem {
        double value = sum();
        if (place < text.length()) throw new SyntaxProblem("unexpected " + text.charAt(place), place);
        return value;
    }

    private double sum() throws SyntaxProblem {
        double value = product();
        while (place < text.length()) {
            char sign = text.charAt(place);
            if (sign != '+' && sign != '-') break;
            place++;
            double other = product();
            value = sign == '+' ? value + other : value - other;
        }
        return value;
    }

    private double product() throws SyntaxProblem {
        double value = factor();
        while (place < text.length()) {
            char sign = text.charAt(place);
            if (sign != '*' && sign != '/') break;
            place++;
            double other = factor();
            if (sign == '/' && other == 0) throw new SyntaxProblem("division by zero", place);
            value = sign == '*' ? value * other : value / other;
        }
        return value;
    }

    private double factor() throws SyntaxProblem {
        if (place == text.length()) throw new SyntaxProblem("end", place);
        char first = text.charAt(place);
        if (first == '(') {
            place++;
            double value = sum();
            if (place == text.length() || text.charAt(place) != ')') throw new SyntaxProblem("no )", place);
            place++;
            return value;
        }
        if (first == '-') {
            place++;
            return -factor();
        }
        int start = place;
        while (place < text.length() && (Character.isDigit(text.charAt(place)) || text.charAt(place) == '.')) place++;
        if (start == place) throw new SyntaxProblem("no number", place);
        return Double.parseDouble(text.substring(start, place));
    }

    static String told(String text) {
        try {
            return text + " = " + new Calculator(text).value();
        } catch (SyntaxProblem problem) {
            return problem.getMessage() + (problem.place == text.length() ? "!" : "");
        }
    }

    public static void main(String[] arguments) {
        String[] texts = {"1+2*3", "(1+2)*3", "10/4-1", "-(2-5)*1.5", "2*", "1/0", "(1", "3 4", "2*(3+4)*5"};
        for (String text : texts) System.out.println(told(text)); // expect 1+2*3 = 7.0
        // expect (1+2)*3 = 9.0
        // expect 10/4-1 = 1.5
        // expect -(2-5)*1.5 = 4.5
        // expect end at 2!
        // expect division by zero at 3!
        // expect no ) at 2!
        // expect unexpected   at 1
        // expect 2*(3+4)*5 = 70.0
    }
}
